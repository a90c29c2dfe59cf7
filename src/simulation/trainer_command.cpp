// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/trainer_command.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace agv::simulation {
namespace {

constexpr double longest_s = 3600.0;
constexpr double farthest_mm = 100'000.0;
constexpr std::size_t longestEcho = 40;

/// The words of a line after the first; remembers the first thing that is wrong with them.
class Words {
public:
    explicit Words(std::string_view line)
    {
        constexpr std::string_view blanks = " \t\r\n";
        for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
            const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
            m_words.push_back(line.substr(at, end - at));
            at = line.find_first_not_of(blanks, end);
        }
    }

    bool isEmpty() const { return m_words.empty(); }
    bool hasMore() const { return m_next < m_words.size(); }
    std::string_view peek() const { return hasMore() ? m_words[m_next] : std::string_view{}; }
    std::string_view word(const char* what)
    {
        if (hasMore())
            return m_words[m_next++];
        fail(std::string("missing ") + what);
        return {};
    }

    double number(const char* what, double low, double high)
    {
        const std::string_view text = word(what);
        double value = 0.0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool wellFormed = !text.empty() && error == std::errc{} && stop == text.data() + text.size();
        if (wellFormed && value >= low && value <= high) // false for NaN
            return value;
        wrong(what, text, "expected a number from " + plain(low) + " to " + plain(high));
        return low;
    }
    std::size_t count(const char* what, double high)
    {
        const double value = number(what, 1.0, high);
        if (value != std::floor(value))
            fail(std::string(what) + " is not a whole number");
        return static_cast<std::size_t>(value);
    }
    int anchor()
    {
        const double id = number("anchor number", 0.0, 7.0);
        if (id != std::floor(id))
            fail("anchor number is not a whole number");
        return static_cast<int>(id);
    }
    RobotId robot() { return {static_cast<int>(count("robot number", 1000.0))}; }
    TagUid tag()
    {
        const std::string_view text = word("tag UID");
        if (const auto uid = parseTagUid(text))
            return *uid;
        wrong("tag UID", text, "expected 1 to 16 hexadecimal digits");
        return {};
    }
    Device device()
    {
        const std::string_view text = word("device");
        if (text != "reader" && text != "robot")
            wrong("device", text, "expected 'reader' or 'robot'");
        const auto kind = text == "reader" ? Device::Kind::Reader : Device::Kind::Robot;
        return {kind, robot()};
    }
    std::uint16_t port(const char* what)
    {
        return static_cast<std::uint16_t>(count(what, std::numeric_limits<std::uint16_t>::max()));
    }

    void fail(std::string what)
    {
        if (!m_error)
            m_error = std::move(what);
    }
    const std::optional<std::string>& error() const { return m_error; }

    static std::string echo(std::string_view text)
    {
        std::string shown(text.substr(0, longestEcho));
        std::ranges::replace_if(shown, [](char c) { return c < ' ' || c > '~'; }, '?');
        return "'" + shown + (text.size() > longestEcho ? "...'" : "'");
    }

private:
    static std::string plain(double value)
    {
        std::array<char, 32> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
        return {text.data(), end};
    }
    void wrong(const char* what, std::string_view text, const std::string& expected)
    {
        fail(std::string(what) + " " + echo(text) + ": " + expected);
    }

    std::vector<std::string_view> m_words;
    std::size_t m_next = 0;
    std::optional<std::string> m_error;
};

TrainerCommand deadTag(Words& words)
{
    if (words.peek() != "random")
        return KillTag{words.tag()};
    words.word("random");
    return KillRandomTags{words.count("number of tags", 100'000.0)};
}

TrainerCommand cut(Words& words)
{
    const Device device = words.device();
    return Cut{device, words.hasMore() ? words.number("seconds", 0.0, longest_s) : 0.0};
}

TrainerCommand stall(Words& words)
{
    const Device device = words.device();
    return Stall{device, words.number("seconds", 0.0, longest_s)};
}

TrainerCommand consoleAt(Words& words)
{
    const std::string host(words.word("host"));
    const std::uint16_t port = words.port("port");
    return ConnectToConsole{{host, port}, words.port("telemetry port")};
}

TrainerCommand swapTags(Words& words)
{
    const TagUid first = words.tag();
    return SwapTags{first, words.tag()};
}

TrainerCommand garbage(Words& words)
{
    if (words.word("device") != "reader")
        words.fail("expected 'reader'");
    const RobotId reader = words.robot();
    return PrintGarbage{reader, words.count("number of bytes", 100'000.0)};
}

TrainerCommand battery(Words& words)
{
    const RobotId robot = words.robot();
    return SetCharge{robot, words.number("per cent", 0.0, 100.0) / 100.0};
}

TrainerCommand antenna(Words& words)
{
    const RobotId robot = words.robot();
    const double forward = words.number("forward offset (mm)", -500.0, 500.0);
    const double left = words.number("left offset (mm)", -500.0, 500.0);
    return ShiftAntenna{robot, {metresFromMm(forward), metresFromMm(left)}};
}

TrainerCommand slip(Words& words)
{
    const RobotId robot = words.robot();
    return SetSlip{robot, words.number("per cent", 0.0, 100.0) / 100.0};
}

TrainerCommand place(Words& words)
{
    const RobotId robot = words.robot();
    const double x = words.number("x (mm)", -farthest_mm, farthest_mm);
    const double y = words.number("y (mm)", -farthest_mm, farthest_mm);
    const double heading = words.number("heading (degrees)", -360.0, 360.0);
    return PlaceRobot{robot, {{metresFromMm(x), metresFromMm(y)}, wrapAngle(radFromDeg(heading))}};
}

TrainerCommand unplug(Words& words)
{
    if (!words.hasMore())
        return UnplugUwb{};
    return UnplugUwb{words.number("seconds", 0.0, longest_s)};
}

TrainerCommand nlos(Words& words)
{
    const int anchor = words.anchor();
    const double extra = words.number("extra length (mm)", 0.0, 10'000.0);
    return BlockAnchor{anchor, metresFromMm(extra), words.number("seconds", 0.0, longest_s)};
}

struct Syntax {
    std::string_view name;
    std::string_view arguments;
    std::string_view meaning;
    TrainerCommand (*read)(Words&);
};

constexpr std::array syntaxes{
    Syntax{"help", "", "this list", [](Words&) -> TrainerCommand { return ShowHelp{}; }},
    Syntax{"truth", "", "where every AGV really is", [](Words&) -> TrainerCommand { return ShowTruth{}; }},
    Syntax{"console", "HOST PORT UDPPORT", "robots connect there", consoleAt},
    Syntax{"cut", "reader N|robot N [SECONDS]", "closes the connections; stays away for SECONDS", cut},
    Syntax{"stall", "reader N|robot N SECONDS", "nothing goes through for so long", stall},
    Syntax{"halfopen", "reader N|robot N", "power loss: sockets stay open, nothing is answered",
           [](Words& words) -> TrainerCommand { return HalfOpen{words.device()}; }},
    Syntax{"garbage", "reader N COUNT", "COUNT bytes of line noise", garbage},
    Syntax{"deadtag", "UID | random N", "tags that never answer again", deadTag},
    Syntax{"swaptags", "UID UID", "two tags exchange their places", swapTags},
    Syntax{"battery", "N PERCENT", "charge of robot N", battery},
    Syntax{"antenna", "N FORWARD_MM LEFT_MM", "moves the antenna of robot N", antenna},
    Syntax{"table", "PERCENT", "true RSSI edges lie so much farther out than the table says",
           [](Words& words) -> TrainerCommand {
               return SetTableError{words.number("per cent", -50.0, 50.0) / 100.0};
           }},
    Syntax{"miss", "PERCENT", "share of tags not heard at a place, and of single answers lost",
           [](Words& words) -> TrainerCommand {
               return SetMissRate{words.number("per cent", 0.0, 100.0) / 100.0};
           }},
    Syntax{"slip", "N PERCENT", "share of its travel that robot N loses", slip},
    Syntax{"robot-error", "N", "robot N fails (interrupt or restore clears it)",
           [](Words& words) -> TrainerCommand { return FailRobot{words.robot()}; }},
    Syntax{"place", "N X_MM Y_MM HEADING_DEG", "puts robot N there", place},
    Syntax{"unplug", "[SECONDS]", "takes the UWB unit off its port, for SECONDS or until plug", unplug},
    Syntax{"plug", "", "the UWB unit is back on its port",
           [](Words&) -> TrainerCommand { return PlugUwb{}; }},
    Syntax{"nlos", "ANCHOR MM SECONDS", "all UWB tags see this anchor MM too far away", nlos},
    Syntax{"dropanchor", "ANCHOR", "UWB anchor that no tag hears any more",
           [](Words& words) -> TrainerCommand { return DropAnchor{words.anchor()}; }},
    Syntax{"restore", "", "undoes every fault but battery and place",
           [](Words&) -> TrainerCommand { return Restore{}; }},
    Syntax{"quit", "", "ends the simulation", [](Words&) -> TrainerCommand { return Quit{}; }},
};

} // namespace

Result<TrainerCommand> parseTrainerCommand(std::string_view line)
{
    Words words(line);
    if (words.isEmpty())
        return failure(ErrorCode::BadInput, "empty command; 'help' lists the commands");
    const std::string_view name = words.word("command");
    const auto syntax = std::ranges::find(syntaxes, name, &Syntax::name);
    if (syntax == syntaxes.end())
        return failure(ErrorCode::BadInput,
                       "unknown command " + Words::echo(name) + "; 'help' lists the commands");
    TrainerCommand command = syntax->read(words);
    if (words.hasMore())
        words.fail("unexpected " + Words::echo(words.peek()));
    if (words.error())
        return failure(ErrorCode::BadInput, std::string(name) + ": " + *words.error() + "; usage: " +
                                                std::string(name) + " " + std::string(syntax->arguments));
    return command;
}

std::vector<std::string> trainerHelp()
{
    std::vector<std::string> lines;
    for (const Syntax& syntax : syntaxes)
        lines.push_back(std::string(syntax.name) + (syntax.arguments.empty() ? "" : " ") +
                        std::string(syntax.arguments) + ": " + std::string(syntax.meaning));
    return lines;
}

} // namespace agv::simulation
