// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "radcert/formats/problem/node_file.h"

namespace radcert::python {

/// Nodes of a user's own, from a file or from Python.
struct Nodes {
  std::string name;
  std::shared_ptr<const NodeFile> file;
};

}  // namespace radcert::python
