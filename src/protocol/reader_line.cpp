// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/reader_line.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace agv::protocol {

namespace {

constexpr std::string_view scanBegin = "SCAN:";
constexpr std::string_view completeBegin = "+UID=";
constexpr std::string_view incompleteBegin = "-UID=";
constexpr std::string_view rssiBegin = "+RSSI=";
constexpr std::string_view okText = "OK";
constexpr std::string_view inventoryBegin = "+TAGS=";
constexpr std::string_view rc522Begin = "Card read UID:";
constexpr std::size_t uidDigits = 16;
constexpr int rc522Bytes = 4;
constexpr std::size_t inventoryDigits = 4;

using Failure = std::unexpected<ReaderLineError>;
template<typename T>
using Decoded = std::expected<T, ReaderLineError>;

bool isBlank(char c) { return c == ' ' || c == '\t'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isHexDigit(char c) { return isDigit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f'); }
bool isText(char c) { return (c >= ' ' && c <= '~') || c == '\t'; }

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// What is left of a line; every take... function removes what it recognises from the front.
class Scanner {
public:
    explicit Scanner(std::string_view rest) : m_rest(rest) {}

    bool atEnd() const { return m_rest.empty(); }
    std::string_view rest() const { return m_rest; }
    /// Stops early: what is left is the beginning of `token`, but not all of it.
    bool isCutIn(std::string_view token) const
    {
        return m_rest.size() < token.size() && token.starts_with(m_rest);
    }

    void skipBlanks()
    {
        while (!m_rest.empty() && isBlank(m_rest.front()))
            m_rest.remove_prefix(1);
    }
    bool take(std::string_view token)
    {
        if (!m_rest.starts_with(token))
            return false;
        m_rest.remove_prefix(token.size());
        return true;
    }
    /// The longest run of characters for which `belongs` holds.
    template<typename Predicate>
    std::string_view takeRun(Predicate belongs)
    {
        const auto end = std::find_if_not(m_rest.begin(), m_rest.end(), belongs);
        const auto run = m_rest.substr(0, static_cast<std::size_t>(end - m_rest.begin()));
        m_rest.remove_prefix(run.size());
        return run;
    }

private:
    std::string_view m_rest;
};

Decoded<TagUid> takeUid(Scanner& line)
{
    line.skipBlanks();
    const std::string_view digits = line.takeRun(isHexDigit);
    if (digits.size() < uidDigits && line.atEnd())
        return Failure(ReaderLineError::Truncated);
    if (digits.size() != uidDigits)
        return Failure(ReaderLineError::BadUid);
    TagUid uid;
    std::from_chars(digits.data(), digits.data() + digits.size(), uid.value, 16);
    return uid;
}

/// One digit 0..7 of a channel.
Decoded<int> takeRssi(Scanner& line)
{
    line.skipBlanks();
    if (line.atEnd())
        return Failure(ReaderLineError::Truncated);
    const std::string_view digits = line.takeRun(isDigit);
    if (digits.size() != 1 || digits.front() > '7')
        return Failure(ReaderLineError::BadRssi);
    return digits.front() - '0';
}

Decoded<ReaderReport> finished(Scanner& line, const ReaderReport& report)
{
    line.skipBlanks();
    if (!line.atEnd())
        return Failure(ReaderLineError::TrailingText);
    return report;
}

/// After "SCAN:+UID=" or "+UID=".
Decoded<ReaderReport> decodeComplete(Scanner line)
{
    const auto uid = takeUid(line);
    if (!uid)
        return Failure(uid.error());
    line.skipBlanks();
    line.take(",");
    line.skipBlanks();
    if (line.isCutIn(rssiBegin))
        return Failure(ReaderLineError::Truncated);
    if (!line.take(rssiBegin))
        return Failure(ReaderLineError::BadRssi);
    const auto main = takeRssi(line);
    if (!main)
        return Failure(main.error());
    CompleteRead read{.uid = *uid, .rssi = *main};
    line.skipBlanks();
    if (line.take("/")) {
        const auto auxiliary = takeRssi(line);
        if (!auxiliary)
            return Failure(auxiliary.error());
        read.auxiliaryRssi = *auxiliary;
    }
    return finished(line, read);
}

/// After "SCAN:-UID=".
Decoded<ReaderReport> decodeIncomplete(Scanner line)
{
    const auto uid = takeUid(line);
    if (!uid)
        return Failure(uid.error());
    return finished(line, IncompleteRead{*uid});
}

/// After "+TAGS=".
Decoded<ReaderReport> decodeInventory(Scanner line)
{
    line.skipBlanks();
    if (line.atEnd())
        return Failure(ReaderLineError::Truncated);
    const std::string_view digits = line.takeRun(isDigit);
    if (digits.empty() || digits.size() > inventoryDigits)
        return Failure(ReaderLineError::BadCount);
    InventoryCount count;
    std::from_chars(digits.data(), digits.data() + digits.size(), count.tags);
    return finished(line, count);
}

/// After "Card read UID:".
Decoded<ReaderReport> decodeRc522(Scanner line)
{
    Rc522Read read;
    for (int i = 0; i < rc522Bytes; ++i) {
        line.skipBlanks();
        if (line.atEnd())
            return Failure(ReaderLineError::Truncated);
        if (i > 0 && !line.take(","))
            return Failure(ReaderLineError::BadUid);
        line.skipBlanks();
        if (line.atEnd())
            return Failure(ReaderLineError::Truncated);
        const std::string_view digits = line.takeRun(isDigit);
        unsigned value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (digits.empty() || digits.size() > 3 || value > 255)
            return Failure(ReaderLineError::BadUid);
        read.uid.value = read.uid.value << 8U | value;
    }
    return finished(line, read);
}

struct LineForm {
    std::string_view begin;
    Decoded<ReaderReport> (*decode)(Scanner afterBegin);
};

constexpr std::array scanForms{LineForm{completeBegin, decodeComplete},
                               LineForm{incompleteBegin, decodeIncomplete}};
constexpr std::array plainForms{LineForm{completeBegin, decodeComplete},
                                LineForm{inventoryBegin, decodeInventory}, LineForm{rc522Begin, decodeRc522}};

/// Finds the form by its beginning; a line that stops inside the beginning of a form is truncated.
template<std::size_t n>
Decoded<ReaderReport> decodeForms(const std::array<LineForm, n>& forms, Scanner line, ReaderLineError noForm)
{
    bool cut = false;
    for (const LineForm& form : forms) {
        if (line.take(form.begin))
            return form.decode(line);
        cut = cut || line.isCutIn(form.begin);
    }
    return Failure(cut ? ReaderLineError::Truncated : noForm);
}

struct LineText {
    std::string operator()(const CompleteRead& read) const
    {
        std::string text = "SCAN:+UID=" + fullText(read.uid) + ",+RSSI=" + std::to_string(read.rssi);
        if (read.auxiliaryRssi >= 0)
            text += "/" + std::to_string(read.auxiliaryRssi);
        return text;
    }
    std::string operator()(const IncompleteRead& read) const { return "SCAN:-UID=" + fullText(read.uid); }
    std::string operator()(const ReaderOk&) const { return std::string(okText); }
    std::string operator()(const InventoryCount& count) const
    {
        return std::string(inventoryBegin) + std::to_string(count.tags);
    }
    std::string operator()(const Rc522Read& read) const
    {
        std::string text(rc522Begin);
        for (int shift = 24; shift >= 0; shift -= 8)
            text += (shift == 24 ? " " : ",") +
                    std::to_string(read.uid.value >> static_cast<unsigned>(shift) & 0xFFU);
        return text;
    }
};

} // namespace

Decoded<ReaderReport> decodeReaderLine(std::string_view line)
{
    line = trimmed(line);
    if (line.empty() || !std::ranges::all_of(line, isText))
        return Failure(ReaderLineError::Noise);
    Scanner scanner(line);
    if (scanner.take(okText))
        return finished(scanner, ReaderOk{});
    if (scanner.isCutIn(okText) || scanner.isCutIn(scanBegin))
        return Failure(ReaderLineError::Truncated);
    if (scanner.take(scanBegin))
        return decodeForms(scanForms, scanner, ReaderLineError::BadUid);
    return decodeForms(plainForms, scanner, ReaderLineError::Noise);
}

std::string encodeReaderLine(const ReaderReport& report) { return std::visit(LineText{}, report); }

const char* toText(ReaderLineError error)
{
    switch (error) {
    case ReaderLineError::Noise:
        return "noise";
    case ReaderLineError::BadUid:
        return "bad UID";
    case ReaderLineError::BadRssi:
        return "bad RSSI";
    case ReaderLineError::Truncated:
        return "truncated";
    case ReaderLineError::TrailingText:
        return "trailing text";
    case ReaderLineError::Overlong:
        return "over-long";
    case ReaderLineError::BadCount:
        return "bad tag count";
    }
    return "unknown";
}

} // namespace agv::protocol
