// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_tree.h"

#include "core/file_units.h"
#include "core/json_location.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>

namespace agv {
namespace {

/// What people did when the library says this.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> syntaxHelp{{
    {"unexpected string literal; expected '}'", "a comma is missing before this key"},
    {"unexpected string literal; expected ']'", "a comma is missing before this value"},
    {"unexpected '{'; expected ']'", "a comma is missing before this brace"},
    {"unexpected '}'; expected string literal", "remove the comma before this brace"},
    {"while parsing value - unexpected ']'", "remove the comma before this bracket"},
    {"while parsing object key - invalid literal", "a key stands in quotation marks"},
    {"while parsing value - invalid literal",
     "expected a number, a text in quotation marks, true, false, null, [...] or {...}"},
    {"expected end of input", "nothing may follow the end of the plant"},
}};

/// Builds the tree while the library's parser reads, and stops it at what the library would let pass.
class TreeBuilder : public nlohmann::json_sax<Json> {
public:
    TreeBuilder(std::string_view text, std::string_view name) : m_text(text), m_name(name) {}

    Result<Json> take() &&
    {
        if (m_error)
            return std::unexpected(*m_error);
        return std::move(m_root);
    }

    bool null() override { return add(nullptr) != nullptr; }
    bool boolean(bool value) override { return add(value) != nullptr; }
    bool number_integer(std::int64_t value) override { return add(value) != nullptr; }
    bool number_unsigned(std::uint64_t value) override { return add(value) != nullptr; }
    bool number_float(long double value, const std::string&) override { return add(value) != nullptr; }
    bool string(std::string& value) override { return add(std::move(value)) != nullptr; }
    bool binary(Json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_array() override { return close(); }

    bool key(std::string& value) override
    {
        Level& level = m_levels.back();
        if (!level.keys.insert(value).second)
            return refuseSecondKey(value);
        level.key = value;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const Json::exception& exception) override
    {
        // The library counts from 1 and points at the last byte of what it could not use.
        const std::string_view what = exception.what();
        std::size_t offset = std::min(position == 0 ? 0 : position - 1, m_text.size());
        if (isWholeToken(what) && token.size() <= offset + 1)
            offset -= token.size() - 1;
        return fail(offset, explain(what, offset));
    }

private:
    struct Level {
        Json* node = nullptr;
        std::string key;
        std::unordered_set<std::string> keys;
    };

    Json* add(Json value)
    {
        if (m_levels.empty()) {
            m_root = std::move(value);
            return &m_root;
        }
        Level& level = m_levels.back();
        if (level.node->is_array()) {
            level.node->push_back(std::move(value));
            return &level.node->back();
        }
        // Appends without the search for an equal key, which key() has already made.
        auto& members = level.node->get_ref<Json::object_t&>();
        members.Container::emplace_back(std::move(level.key), std::move(value));
        return &members.back().second;
    }

    bool open(Json container)
    {
        if (m_levels.size() >= maxJsonDepth)
            return fail(locateValue(m_text, pointer()).value_or(0),
                        "nested deeper than " + std::to_string(maxJsonDepth) + " levels");
        Json* const node = add(std::move(container));
        m_levels.push_back({node, {}, {}});
        return true;
    }

    bool close()
    {
        m_levels.pop_back();
        return true;
    }

    /// Of the innermost open container.
    std::string pointer() const
    {
        std::string path;
        for (std::size_t i = 0; i + 1 < m_levels.size(); ++i) {
            const Json& node = *m_levels[i].node;
            path += '/';
            path += node.is_array() ? std::to_string(node.size() - 1)
                                    : pointerToken(node.get_ref<const Json::object_t&>().back().first);
        }
        return path;
    }

    bool refuseSecondKey(const std::string& key)
    {
        const std::string path = pointer() + "/" + pointerToken(key);
        const std::size_t first = locateKey(m_text, path, 1).value_or(0);
        const std::size_t second = locateKey(m_text, path, 2).value_or(first);
        const TextPlace place = placeAt(m_text, first);
        return fail(second, path + ": the key is already used at " + std::to_string(place.line) + ":" +
                                std::to_string(place.column) + "; remove one of the two");
    }

    /// Whether the library hands over all of the token it refuses; of others only something near it.
    static bool isWholeToken(std::string_view what)
    {
        return what.contains("unexpected string literal") || what.contains("unexpected number literal") ||
               what.contains("out_of_range.406");
    }

    std::string explain(std::string_view what, std::size_t offset) const
    {
        if (m_text.find_first_not_of(" \t\r\n") == std::string_view::npos)
            return "the file is empty";
        if (what.contains("out_of_range.406"))
            return "the number is too large; no value of a plant file comes near";
        if (offset >= m_text.size())
            return "the text ends too early; a bracket, brace or quotation mark is not closed";
        for (const auto& [fragment, meaning] : syntaxHelp) {
            if (what.contains(fragment))
                return "not JSON: " + std::string(meaning);
        }
        // The library's own words without its number, its place and the text around.
        if (const auto colon = what.find(": "); colon != std::string_view::npos)
            what.remove_prefix(colon + 2);
        return "not JSON: " + std::string(what.substr(0, what.find("; last read")));
    }

    bool fail(std::size_t offset, const std::string& reason)
    {
        m_error = Error{ErrorCode::BadInput, placeText(m_name, m_text, offset) + reason};
        return false;
    }

    std::string_view m_text;
    std::string_view m_name;
    Json m_root;
    std::vector<Level> m_levels;
    std::optional<Error> m_error;
};

/// Offset of the first byte that is no UTF-8 (Unicode 15, table 3-7).
std::optional<std::size_t> firstBadUtf8(std::string_view text)
{
    const auto byteAt = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    for (std::size_t i = 0; i < text.size();) {
        const unsigned lead = byteAt(i);
        const std::size_t length = lead < 0x80                   ? 1
                                   : lead >= 0xC2 && lead < 0xE0 ? 2
                                   : lead >= 0xE0 && lead < 0xF0 ? 3
                                   : lead >= 0xF0 && lead < 0xF5 ? 4
                                                                 : 0;
        if (length == 0)
            return i;
        const unsigned lowest = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
        const unsigned highest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
        for (std::size_t k = 1; k < length; ++k) {
            const unsigned follow = byteAt(i + k);
            if (follow < (k == 1 ? lowest : 0x80) || follow > (k == 1 ? highest : 0xBF))
                return i;
        }
        i += length;
    }
    return std::nullopt;
}

std::string numberText(const Json& value)
{
    if (value.is_number_unsigned())
        return std::to_string(value.get<std::uint64_t>());
    if (value.is_number_integer())
        return std::to_string(value.get<std::int64_t>());
    const auto number = value.get<long double>();
    return std::isfinite(number) ? decimalText(number) : "null";
}

bool fitsOneLine(const Json& value)
{
    const auto isScalar = [](const Json& item) { return item.is_primitive(); };
    const auto isPair = [&](const Json& item) {
        return item.is_array() && std::all_of(item.begin(), item.end(), isScalar);
    };
    return std::all_of(value.begin(), value.end(),
                       [&](const Json& item) { return isScalar(item) || isPair(item); });
}

class Printer {
public:
    std::string print(const Json& value)
    {
        write(value, 0);
        m_out += '\n';
        return std::move(m_out);
    }

private:
    static constexpr std::size_t lineLimit = 130;

    void write(const Json& value, std::size_t indent)
    {
        if (value.is_number())
            m_out += numberText(value);
        else if (value.is_primitive())
            m_out += value.dump();
        else if (value.empty())
            m_out += value.is_array() ? "[]" : "{}";
        else if (!writeOnOneLine(value))
            writeOnLines(value, indent);
    }

    bool writeOnOneLine(const Json& value)
    {
        if (!fitsOneLine(value))
            return false;
        const std::size_t before = m_out.size();
        writeItems(value, "", ", ", 0);
        const std::size_t lineStart = m_out.rfind('\n', before) + 1;
        if (m_out.size() - lineStart <= lineLimit)
            return true;
        m_out.resize(before);
        return false;
    }

    void writeOnLines(const Json& value, std::size_t indent)
    {
        const std::string blanks = "\n" + std::string(indent + 2, ' ');
        writeItems(value, blanks, "," + blanks, indent);
    }

    void writeItems(const Json& value, const std::string& first, const std::string& between,
                    std::size_t indent)
    {
        m_out += value.is_array() ? '[' : '{';
        bool isFirst = true;
        for (const auto& [key, item] : value.items()) {
            m_out += isFirst ? first : between;
            isFirst = false;
            if (value.is_object())
                m_out += Json(key).dump() + ": ";
            write(item, indent + 2);
        }
        if (!first.empty())
            m_out += "\n" + std::string(indent, ' ');
        m_out += value.is_array() ? ']' : '}';
    }

    std::string m_out;
};

} // namespace

std::string placeText(std::string_view name, std::string_view text, std::size_t offset)
{
    const TextPlace place = placeAt(text, offset);
    return std::string(name) + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
}

Result<Json> parseJson(std::string_view text, std::string_view name)
{
    if (const auto bad = firstBadUtf8(text))
        return failure(ErrorCode::BadInput,
                       placeText(name, text, *bad) +
                           "the byte is not UTF-8 text; save the file with UTF-8 encoding");
    TreeBuilder builder(text, name);
    Json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder).take();
}

std::string printJson(const Json& value) { return Printer().print(value); }

} // namespace agv
