// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/version.h"

#include <iostream>

int main() { std::cout << "radcert " << radcert::version() << '\n'; }
