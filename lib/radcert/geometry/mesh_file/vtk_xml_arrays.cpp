// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/vtk_xml_arrays.h"

#include <expat.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "radcert/core/base64.h"
#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";
constexpr std::string_view grid_allowed = "<VTKFile type=\"UnstructuredGrid\">";

std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::string VtkArray::attribute(const std::string& name) const {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string() : found->second;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t stop = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, stop - at));
    at = text.find_first_not_of(blanks, stop);
  }
  return words;
}

/// What Expat calls while it reads. A refusal must not pass through Expat's C code: it is kept.
class VtkXmlHandler {
public:
  explicit VtkXmlHandler(VtkXmlFile& file)
      : file_(&file), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          static_cast<VtkXmlHandler*>(self)->guarded([&](VtkXmlHandler& h) { h.begin(name, attributes); });
        },
        [](void* self, const XML_Char*) {
          static_cast<VtkXmlHandler*>(self)->guarded([](VtkXmlHandler& h) { h.end(); });
        });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const XML_Char* text, int length) {
      static_cast<VtkXmlHandler*>(self)->guarded([&](VtkXmlHandler& h) {
        if (h.array_ != nullptr) h.array_->text.append(text, static_cast<std::size_t>(length));
      });
    });
  }

  void read(std::string_view xml) {
    // In parts: Expat counts in int.
    constexpr std::size_t part = std::size_t{1} << 24U;
    for (std::size_t at = 0; at < xml.size() || at == 0; at += part) {
      const std::string_view now = xml.substr(at, part);
      const bool last = at + part >= xml.size();
      const XML_Status status =
          XML_Parse(parser_.get(), now.data(), static_cast<int>(now.size()), last ? 1 : 0);
      if (refusal_) std::rethrow_exception(refusal_);
      if (status != XML_STATUS_OK)
        refuse_mesh(place(), std::nullopt,
                    std::string("is no XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())),
                    "a VTK file: " + std::string(grid_allowed));
      if (last) return;
    }
  }

private:
  template <class Action>
  void guarded(const Action& action) {
    if (refusal_) return;
    try {
      action(*this);
    } catch (...) {
      refusal_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  std::string place() const { return "line " + std::to_string(XML_GetCurrentLineNumber(parser_.get())); }

  void begin(const std::string& name, const XML_Char** list) {
    std::map<std::string, std::string> attributes;
    for (; *list != nullptr; list += 2) attributes[list[0]] = list[1];
    if (open_.empty()) head(name, attributes);
    open_.push_back(name);
    if (name == "Piece") {
      const auto points = number_in(attributes["NumberOfPoints"]);
      const auto cells = number_in(attributes["NumberOfCells"]);
      if (!points || !cells)
        refuse_mesh(place(), std::nullopt, "is a piece without its numbers",
                    "NumberOfPoints and NumberOfCells");
      file_->pieces_.push_back({.points = *points, .cells = *cells, .arrays = {}, .place = place()});
    }
    if (name != "DataArray" && name != "Array") return;
    const std::string section = open_.size() > 1 ? open_[open_.size() - 2] : std::string();
    std::vector<VtkArray>* into = nullptr;
    if (section == "FieldData")
      into = &file_->fields_;
    else if (!file_->pieces_.empty())
      into = &file_->pieces_.back().arrays;
    if (into == nullptr) return;
    into->push_back({.section = section, .attributes = std::move(attributes), .text = {}, .place = place()});
    array_ = &into->back();
  }

  void end() {
    if (open_.back() == "DataArray" || open_.back() == "Array") array_ = nullptr;
    open_.pop_back();
  }

  void head(const std::string& name, std::map<std::string, std::string>& attributes) {
    if (name != "VTKFile" || attributes["type"] != "UnstructuredGrid")
      refuse_mesh(place(), name == "VTKFile" ? attributes["type"] : name, "is no unstructured grid of VTK",
                  std::string(grid_allowed));
    const std::string& order = attributes["byte_order"];
    file_->big_endian_ = order == "BigEndian";
    const std::string& header = attributes["header_type"];
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      refuse_mesh(place(), header, "is no type of a header", "UInt32 or UInt64");
    file_->header_bytes_ = header == "UInt64" ? 8 : 4;
    const std::string& compressor = attributes["compressor"];
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      refuse_mesh(place(), compressor, "is a compressor that is not read",
                  "vtkZLibDataCompressor, or none; in ParaView: Compressor Type ZLib");
    file_->compressed_ = !compressor.empty();
  }

  VtkXmlFile* file_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::vector<std::string> open_;
  VtkArray* array_ = nullptr;
  std::exception_ptr refusal_;
};

VtkXmlFile::VtkXmlFile(std::string_view bytes) {
  // What is appended need not be XML: it is cut out before.
  constexpr std::string_view begin = "<AppendedData";
  constexpr std::string_view end = "</AppendedData>";
  std::string_view xml = bytes;
  std::string closed;
  if (const std::size_t at = bytes.find(begin); at != std::string_view::npos) {
    const std::size_t open = bytes.find('>', at);
    const std::size_t mark =
        open == std::string_view::npos ? open : bytes.find_first_not_of(blanks, open + 1);
    const std::size_t stop = bytes.rfind(end);
    if (mark == std::string_view::npos || bytes[mark] != '_' || stop == std::string_view::npos ||
        stop <= mark)
      refuse_mesh("byte " + std::to_string(at), std::nullopt, "begins no appended data",
                  "an underscore, the data and </AppendedData>");
    const std::string_view tag = bytes.substr(at, open - at);
    appended_is_raw_ = tag.find("\"raw\"") != std::string_view::npos;
    appended_ = bytes.substr(mark + 1, stop - mark - 1);
    closed = std::string(bytes.substr(0, at)) + std::string(bytes.substr(stop + end.size()));
    xml = closed;
  }
  VtkXmlHandler(*this).read(xml);
}

/// The bytes of one array, taken one part after the other; a part in base64 is filled up on its own.
class VtkXmlFile::Source {
public:
  Source(std::string_view bytes, bool is_text, std::string place)
      : bytes_(bytes), is_text_(is_text), place_(std::move(place)) {}

  std::string take(std::uint64_t count) {
    constexpr std::uint64_t letters = 4;
    constexpr std::uint64_t held = 3;
    const std::uint64_t length =
        is_text_ ? count / held * letters + (count % held == 0 ? 0 : letters) : count;
    if (count > bytes_.size() || length > bytes_.size())
      refuse_mesh(place_, std::nullopt,
                  "is an array that is cut off: " + std::to_string(count) + " bytes are missing",
                  "as many bytes as its header says");
    const std::string_view part = bytes_.substr(0, length);
    bytes_.remove_prefix(length);
    if (!is_text_) return std::string(part);
    const std::optional<std::string> plain = from_base64(part);
    if (!plain || plain->size() < count)
      refuse_mesh(place_, std::nullopt, "is no base64", "letters, digits, + and /, filled up with =");
    return plain->substr(0, count);
  }
  /// The same, and what it begins with stays.
  [[nodiscard]] std::string peek(std::uint64_t count) const { return Source(*this).take(count); }

private:
  std::string_view bytes_;
  bool is_text_;
  std::string place_;
};

namespace {

template <class T>
T number_at(std::string_view bytes, std::size_t place, bool big_endian) {
  std::array<char, sizeof(T)> own{};
  std::memcpy(own.data(), bytes.data() + place * sizeof(T), sizeof(T));
  if (big_endian) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

template <class T, class To>
std::vector<To> numbers(std::string_view bytes, bool big_endian) {
  std::vector<To> out;
  for (std::size_t k = 0; k < bytes.size() / sizeof(T); ++k)
    out.push_back(static_cast<To>(number_at<T>(bytes, k, big_endian)));
  return out;
}

}  // namespace

std::string VtkXmlFile::binary(const VtkArray& array) const {
  const std::string format = array.attribute("format");
  std::string_view bytes = array.text;
  bool is_text = true;
  if (format == "appended") {
    const auto offset = number_in(array.attribute("offset"));
    if (!offset || *offset >= appended_.size())
      refuse_mesh(array.place, array.attribute("offset"), "is no offset in what is appended",
                  "a number below " + std::to_string(appended_.size()));
    bytes = appended_.substr(*offset);
    is_text = !appended_is_raw_;
  } else if (format != "binary") {
    refuse_mesh(array.place, format, "is a form that is not read", "ascii, binary, appended");
  }
  if (is_text) bytes.remove_prefix(std::min(bytes.find_first_not_of(blanks), bytes.size()));
  Source source(bytes, is_text, array.place);
  const auto header = [&](const std::string& text, std::size_t place) -> std::uint64_t {
    return header_bytes_ == 8 ? number_at<std::uint64_t>(text, place, big_endian_)
                              : number_at<std::uint32_t>(text, place, big_endian_);
  };
  if (!compressed_) {
    const std::uint64_t length = header(source.peek(header_bytes_), 0);
    if (length > bytes.size()) (void)source.take(length);  // refused as cut off
    return source.take(header_bytes_ + length).substr(header_bytes_);
  }
  constexpr std::uint64_t fixed = 3;  // number of blocks, size of each, size of a last one that is smaller
  const std::uint64_t blocks = header(source.peek(header_bytes_), 0);
  if (blocks > bytes.size()) (void)source.take(blocks);
  const std::string head = source.take((fixed + blocks) * header_bytes_);
  const std::uint64_t usual = header(head, 1);
  const std::uint64_t last = header(head, 2);
  std::uint64_t packed = 0;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t size = header(head, fixed + k);
    if (size > bytes.size()) (void)source.take(size);
    packed += size;
  }
  const std::string all = source.take(packed);
  std::string out;
  std::size_t at = 0;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t size = header(head, fixed + k);
    const std::uint64_t plain = k + 1 == blocks && last > 0 ? last : usual;
    // No deflated byte stands for more than 1032.
    constexpr std::uint64_t most = 1032;
    if (plain > most * size)
      refuse_mesh(array.place, std::to_string(plain), "is more than a compressed block can hold",
                  "blocks as zlib makes them");
    std::string block(plain, '\0');
    uLongf length = plain;
    const int status = uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                                  reinterpret_cast<const Bytef*>(all.data() + at), size);
    if (status != Z_OK || length != plain)
      refuse_mesh(array.place, std::nullopt, "has a block that zlib does not take",
                  "blocks as zlib makes them");
    out += block;
    at += size;
  }
  return out;
}

std::size_t VtkXmlFile::bytes_of_number(const VtkArray& array) const {
  const std::string type = array.attribute("type");
  if (type == "Int8" || type == "UInt8") return 1;
  if (type == "Int16" || type == "UInt16") return 2;
  if (type == "Int32" || type == "UInt32" || type == "Float32") return 4;
  if (type == "Int64" || type == "UInt64" || type == "Float64") return 8;
  refuse_mesh(array.place, type, "is a type of numbers that is not read",
              "Int8 to Int64, UInt8 to UInt64, Float32, Float64");
}

std::vector<std::int64_t> VtkXmlFile::whole_numbers(const VtkArray& array) const {
  if (array.is_text()) {
    std::vector<std::int64_t> out;
    for (const std::string_view word : words_of(array.text))
      out.push_back(whole_number(word, array.place, "whole numbers"));
    return out;
  }
  const std::string type = array.attribute("type");
  const std::string bytes = binary(array);
  if (bytes.size() % bytes_of_number(array) != 0)
    refuse_mesh(array.place, std::to_string(bytes.size()), "bytes end within a number", "whole numbers");
  if (type == "Int8") return numbers<std::int8_t, std::int64_t>(bytes, big_endian_);
  if (type == "UInt8") return numbers<std::uint8_t, std::int64_t>(bytes, big_endian_);
  if (type == "Int16") return numbers<std::int16_t, std::int64_t>(bytes, big_endian_);
  if (type == "UInt16") return numbers<std::uint16_t, std::int64_t>(bytes, big_endian_);
  if (type == "Int32") return numbers<std::int32_t, std::int64_t>(bytes, big_endian_);
  if (type == "UInt32") return numbers<std::uint32_t, std::int64_t>(bytes, big_endian_);
  // A number beyond 2^63 becomes negative, which is refused where it counts.
  if (type == "Int64" || type == "UInt64") return numbers<std::int64_t, std::int64_t>(bytes, big_endian_);
  refuse_mesh(array.place, type, "are no whole numbers", "Int8 to Int64, UInt8 to UInt64");
}

std::vector<double> VtkXmlFile::coordinates(const VtkArray& array) const {
  const std::string type = array.attribute("type");
  const std::string bytes = binary(array);
  if (type == "Float32") return numbers<float, double>(bytes, big_endian_);
  if (type == "Float64") return numbers<double, double>(bytes, big_endian_);
  refuse_mesh(array.place, type, "is no type of a coordinate", "Float32 or Float64");
}

}  // namespace radcert
