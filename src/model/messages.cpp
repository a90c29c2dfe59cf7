// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/messages.h"

#include "model/jog_messages.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace agv::model {
namespace {

const char* const context = "agv::model::Messages";

// A more special pattern stands before a more general one that matches the same text.
const char* const patterns[] = {
    // session
    QT_TRANSLATE_NOOP("agv::model::Messages", "Listening for robots on %1 (TCP), %2 (UDP)"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Listening for robots on %1 (TCP), no telemetry"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 (TCP), no telemetry"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Not listening yet"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Not listening: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "All AGVs were told to stop: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Stop all was pressed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The operator aborted it"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The console ends"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 tried to connect as a robot and was refused: it is not in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 sent telemetry that was ignored: the plant file has no robot with that address, or "
                      "more than one"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "There is no AGV %1 in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The initialisation turn was not started: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Initialisation turn started"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "a turn is running"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the robot is not connected"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the RFID reader is not connected"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the robot is docked: undock it first"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "the robot is in error: look at the robot, then switch it off and on"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "there is no finished turn"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Stop %1 is not read again: %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The sleeptime was not changed: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The wheel speed was not changed: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The robot connected a second time from %1; its older connection was closed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the robot connected anew, it may have restarted"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot connected from %1"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "THE ROBOT MAY STILL BE MOVING: its link was lost while it drove. Use its own switch. (%1)"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The link to the robot was lost: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The link to the RFID reader was lost: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "it was closed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "a command could not be sent"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Connected"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Closed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 more messages were left out"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is docking"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is docking to charge"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is docked"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is undocking"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is idle"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is driving"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is driving a segment"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is waiting for a segment"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The robot is in error: look at the robot, then switch it off and on"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot's program failed at %1, line %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Connected, but nothing heard for 5 s"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Waiting for the robot to connect: switch it on"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Its pose is doubted. %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The floor tags it reads lie elsewhere: it was moved or slipped; calibrate it again"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Its UWB tag is elsewhere: it was moved; calibrate it again"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It drove by itself to dock or undock: calibrate it again"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The link to the robot was lost while it drove: calibrate it again"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Nothing measured for the last %1 mm of its way: the pose is what "
                      "the commanded speeds make of it"),
    // procedure
    QT_TRANSLATE_NOOP("agv::model::Messages", "Stop %1 is read again"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "No floor tag was read for %1 s: check the RFID reader and that the AGV stands on tags"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "No floor tag was read at stop %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The robot did not report the end of its turn in time: check that its wheels are free"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The solver gave no answer"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The robot reports an error: look at the robot, then switch it off and on"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The robot is docking or docked: undock it first"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The robot stopped in the middle of a turn: look for what it bumped into"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "The robot was stopped %1 ms late: this computer was busy, the step is about %2 degrees "
        "too long"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Number of stops is %1: it must be 8, 12 or 16"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 is %2: it must lie between %3 and %4"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Wheel speed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Settling time"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Shortest dwell"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Longest dwell"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Connected again, but still nothing is heard: no floor tag below the antenna, or the "
                      "reader has no power"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "No answer within %1 s: check the address and that the device has power and Wi-Fi"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Connected, but nothing heard for %1 s: no floor tag below the antenna, or the link is "
                      "dead"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Nothing heard for %1 s: the connection is being made anew"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Connected again, but still nothing is heard: no UWB tag is "
                                              "switched on or in reach, or the unit hangs"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Connected, but nothing heard for %1 s: no UWB tag is switched on or in reach"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "No answer within %1 s: unplug the unit and plug it in again"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The port is not the one of a TREK1000 unit (USB id "
                                              "0483:5740): nothing is sent to it unless you ask for it"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The reports are those of a clone (%1): nothing is sent to it unless you ask for it"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The unit did not tell its version and configuration: the age "
                                              "of its ranges is measured from its reports instead"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The unit is %1: %2 %3, channel %4, %5"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "anchor"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "tag"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "listener"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Not heard for %1 s: the tag is off or out of reach"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchor %1 measures this tag, but is not in the plant file: enter where it is"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchor %1 is not in the list: enter its height to have it placed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Anchor %1 has no ranges to the others and stays where it is"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchor %1 has too few ranges to the others to be placed and stays where it is"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "More than one arrangement fits the ranges and the one nearest to the list was taken: "
                      "look whether it is right, the range between anchors %1 and %2 would tell"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "The range between anchors %1 and %2 is %3 mm too long: look for what stands between them"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "The range between anchors %1 and %2 is %3 mm too short: look for what stands between them"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The range between anchors %1 and %2 (%3 mm) is shorter than the difference of their "
                      "heights (%4 mm): correct the heights in the list"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "There is no anchor in the list: enter the anchors with their heights first"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "No ranges between the anchors were heard: switch the anchors "
                                              "on and connect the unit that is anchor 0"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "Too few pairs of anchors range with each other: three anchors that all see each other are needed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The anchors stand nearly on one line: their ranges do not "
                                              "tell how far beside it; move one of them aside"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "The ranges between the anchors fit no arrangement: look for what hides the anchors from each other"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Only %1 of the 3 ranges that a position needs: look for what hides the anchors"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The ranges fit no position: check the anchors' places in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "There is no anchor in the list: enter where the anchors are"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The place of the tag is not known: enter where it stands"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The time of a calibration must lie between %1 and %2 s: choose another"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "No anchor measured tag %1 %2 times: bring it nearer to the anchors or take longer"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Tag %1 was not heard: switch it on and look whether the anchors are in reach"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The ranges of anchor %1 are wrong by %2 mm: check the places "
                                              "of the tag and the anchor before you use the offset"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The ranges of anchor %1 scatter by %2 mm: look for what hides "
                                              "it, keep the tag still and calibrate again"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchors without an offset, because they measured the tag fewer than %1 times: %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The anchors were changed meanwhile: start the calibration again"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "Ranges fit a place %1 mm from the one in the list: measure the anchor again or restore it"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Ranges are %1 mm too long: the anchor may have been moved or be hidden; look at it"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Ranges are %1 mm too short: the anchor may have been moved; "
                                              "measure it again or calibrate its ranges"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Anchor %1: %2"),
    // link
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 refuses the connection: the device is on, but nothing listens on that port; check "
                      "the port"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 closed the connection: it was switched off, restarted or serves other clients "
                      "already"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 closed the connection: it was switched off or restarted"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The host \"%1\" is not known: check the name in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 no longer answers: check its power and its Wi-Fi"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 does not answer: check the address, its power and its Wi-Fi"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 cannot be reached (%2): check the cable, the Wi-Fi and the address"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The system forbids a connection to %1: check the firewall"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Connection to %1 failed: %2"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "%1 is in use: another console or program holds it; end that program or change the port "
        "in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "%1 is forbidden by the system: ports below 1024 need administrator rights; choose a "
                      "higher port in the plant file"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "%1 does not exist: this computer has no network interface with that address; check the "
        "listen address in the plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 cannot be opened: %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 port %2 on %3"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "\"%1\" is not an address: the listen address of the plant file must be one of this "
                      "computer, such as 127.0.0.1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "There is no serial port %1: plug the unit in, or choose another port"),
    QT_TRANSLATE_NOOP(
        "agv::model::Messages",
        "Serial port %1 is in use: another console, terminal or program holds it; end that program"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "You may not open the serial port %1: install the udev rule %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "You may not open the serial port %1: join the group %2 (sudo usermod -aG %3 $USER, "
                      "then log in anew) or install the udev rule %4"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 is no serial port: choose another port"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Serial port %1 is gone: the unit was unplugged or lost its power; plug it in again"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Serial port %1 failed: %2"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "USB %1, serial number %2"),
    // app
    QT_TRANSLATE_NOOP("agv::model::Messages", "Sleeptime %1 ms is written to %2; there it was %3 ms"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The sleeptime holds for this session only: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the plant is simulated"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "there is no plant file"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Left out: %1 more"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Left out: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "The file has no heights: the new tags have %1 mm until you enter their own"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchors and the corrections of the tags 0 to 7 are written to %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Anchors are written to %1; tags and corrections have no place in that format"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Saved to %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Not saved: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The simulated plant could not be started: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The simulated plant ended unexpectedly (exit status %1)"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "The simulated plant was ended by signal %1"),
};

const char* const sources[] = {
    QT_TRANSLATE_NOOP("agv::model::Messages", "Console"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "RFID reader %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Robot %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "AGV %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "UWB"),
};

const char* const dropWords[] = {
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 unknown type"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 unknown message"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad length"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad value"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 empty"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 noise"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad UID"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad RSSI"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 truncated"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 trailing text"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 over-long"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad tag count"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "%1 bad field"),
};

constexpr int deepest = 4; ///< a sentence in a sentence in a sentence; ends what could only be a loop

/// What stands in `text` for %1, %2 ... of `pattern`, each as short as possible; none when it does not match.
std::optional<QStringList> captures(const QString& pattern, const QString& text)
{
    QStringList values;
    qsizetype inPattern = 0;
    qsizetype inText = 0;
    while (true) {
        const qsizetype mark = pattern.indexOf(QLatin1Char('%'), inPattern);
        const QString literal = pattern.mid(inPattern, mark < 0 ? -1 : mark - inPattern);
        qsizetype found = values.isEmpty() && inPattern == 0 ? 0 : text.indexOf(literal, inText);
        if (mark < 0 && inPattern > 0)
            found = std::max(inText, text.size() - literal.size());
        if (found < 0 || QStringView(text).mid(found, literal.size()) != literal)
            return std::nullopt;
        if (inPattern > 0)
            values << text.mid(inText, found - inText);
        inText = found + literal.size();
        if (mark < 0)
            break;
        inPattern = mark + 2;
    }
    if (inText != text.size() || values.contains(QString()))
        return std::nullopt;
    return values;
}

/// In one pass, so that a value that holds a "%1" itself is not filled in again.
template<typename Translate>
QString filled(const QString& pattern, const QStringList& values, const Translate& translateValue)
{
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const int number = pattern[i] == QLatin1Char('%') ? pattern.mid(i + 1, 1).toInt() : 0;
        if (number >= 1 && number <= values.size()) {
            text += translateValue(values[number - 1]);
            ++i;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

QString translate(std::span<const char* const> known, const QString& english, int depth)
{
    for (const char* pattern : known) {
        const std::optional<QStringList> values = captures(QString::fromUtf8(pattern), english);
        if (!values)
            continue;
        return filled(QCoreApplication::translate(context, pattern), *values, [&](const QString& value) {
            return depth > 0 ? translate(known, value, depth - 1) : value;
        });
    }
    return english;
}

} // namespace

QString Messages::sentence(const std::string& english)
{
    static const std::vector<const char*> all = [] {
        std::vector<const char*> both(std::begin(jogPatterns), std::end(jogPatterns));
        both.insert(both.end(), std::begin(patterns), std::end(patterns));
        return both;
    }();
    return translate(all, QString::fromStdString(english), deepest);
}

QString Messages::source(const std::string& english)
{
    return translate(sources, QString::fromStdString(english), 0);
}

QString Messages::drops(const std::string& english)
{
    QStringList parts = QString::fromStdString(english).split(QStringLiteral(", "));
    for (QString& part : parts)
        part = translate(dropWords, part, 0);
    return parts.join(QStringLiteral(", "));
}

} // namespace agv::model
