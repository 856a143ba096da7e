// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <exception>
#include <new>
#include <string_view>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/version.h"

namespace radcert {
namespace {

/// Where libpng's bytes go; an exception does not pass through its C code, it is kept.
struct Sink {
  std::string bytes;
  std::exception_ptr failure;
};

void append(png_structp png, png_bytep data, std::size_t length) {
  auto& sink = *static_cast<Sink*>(png_get_io_ptr(png));
  try {
    sink.bytes.append(reinterpret_cast<const char*>(data), length);
  } catch (...) {
    sink.failure = std::current_exception();
  }
  if (sink.failure) png_error(png, "no memory");
}

void flush_nothing(png_structp) {}

/// Whether libpng wrote the file. Nothing here has a destructor that the jump back from libpng would leave
/// out.
bool write(Sink& sink, const Image& image, png_bytepp rows, png_textp texts, int text_count) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  constexpr int bits = 8;
  constexpr int smallest_file = 9;
  png_set_write_fn(png, &sink, append, flush_nothing);
  png_set_compression_level(png, smallest_file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()), static_cast<png_uint_32>(image.height()),
               bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
  png_set_text(png, info, texts, text_count);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

std::string png_bytes(const Image& image, const std::string& description) {
  expects(std::all_of(description.begin(), description.end(), [](char c) { return c >= ' ' && c <= '~'; }),
          "a description of printable ASCII", named("description", description));
  std::string key_software = "Software";
  std::string key_description = "Description";
  std::string software = "radcert " + std::string(version());
  std::string shown = description;
  const auto text = [](std::string& key, std::string& words) {
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = key.data();
    entry.text = words.data();
    entry.text_length = words.size();
    return entry;
  };
  std::array<png_text, 2> texts = {text(key_software, software), text(key_description, shown)};
  std::vector<std::uint8_t> bytes(image.bytes().begin(), image.bytes().end());
  std::vector<png_bytep> rows(image.height());
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = bytes.data() + 3 * y * image.width();
  Sink sink;
  if (!write(sink, image, rows.data(), texts.data(), static_cast<int>(texts.size()))) {
    if (sink.failure) std::rethrow_exception(sink.failure);
    throw EnvironmentError("libpng", "could not write a picture");
  }
  return std::move(sink.bytes);
}

}  // namespace radcert
