// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/capture_turns.h"

#include "recording/emulator_line.h"
#include "recording/turn_limits.h"

#include <algorithm>
#include <array>

namespace agv::recording {

namespace {

/// Words of a mark line after '#': "stop", "2", "at_ms=2700".
std::vector<std::string_view> wordsOfMark(std::string_view line)
{
    line = trimmed(line);
    if (!line.starts_with('#'))
        return {};
    return tokensOf(line.substr(1));
}

struct StampedLine {
    std::string_view text;
    Time time;
};

/// "@212.5 SCAN:...": the time in ms, then the line. A line without a stamp has the beginning of the capture.
StampedLine withoutStamp(std::string_view line)
{
    line = withoutLiteralReturn(line);
    if (!line.starts_with('@'))
        return {line, Time{}};
    const std::size_t end = std::min(line.find(' '), line.size());
    const auto time_ms = parseNumber(line.substr(1, end - 1));
    if (!time_ms || !isTime_s(*time_ms * 1e-3))
        return {line, Time{}}; // no stamp of ours: noise, which the decoder refuses
    return {trimmed(line.substr(end)), Time{} + durationFromSeconds(*time_ms * 1e-3)};
}

class CaptureReader {
public:
    explicit CaptureReader(const TurnFileOptions& options) : m_options(options) {}

    void take(const TextLine& line)
    {
        const std::vector<std::string_view> words = wordsOfMark(line.text);
        if (!words.empty())
            takeMark(line.number, words);
        else if (m_turn && m_stop)
            takeReaderLine(line);
    }

    std::vector<RecordedTurn> finish()
    {
        endTurn();
        return std::move(m_turns);
    }

private:
    void takeMark(int line, const std::vector<std::string_view>& words)
    {
        if (words[0] == "turn") {
            beginTurn(line);
            takeParameters(line, words);
        } else if (words[0] == "stop" || words[0] == "retake") {
            takeStop(line, words);
        } else if (words[0] == "moving") {
            m_moving = true;
        } else if (words[0] == "aborted") {
            refuse(line, "the turn was aborted");
            endTurn();
        } else if (words[0] == "end") {
            endTurn();
        }
    }

    void beginTurn(int line)
    {
        endTurn();
        m_turn = TurnRecord{};
        m_turn->nominalStep = m_options.nominalStep;
        m_turn->turnTime_s = m_options.turnTime_s;
        m_firstLine = line;
    }

    void endTurn()
    {
        if (m_turn && m_problem)
            m_turns.push_back({m_firstLine, std::unexpected(*m_problem)});
        else if (m_turn && m_turn->stops.empty())
            m_turns.push_back(
                {m_firstLine, std::unexpected(TurnFileProblem{m_firstLine, "the turn has no stops"})});
        else if (m_turn)
            m_turns.push_back({m_firstLine, std::move(*m_turn)});
        m_turn.reset();
        m_problem.reset();
        m_stop.reset();
        m_moving = false;
    }

    void refuse(int line, std::string reason)
    {
        if (m_turn && !m_problem)
            m_problem = TurnFileProblem{line, std::move(reason)};
    }

    void takeParameters(int line, const std::vector<std::string_view>& words)
    {
        for (const std::string_view word : words) {
            const std::size_t equals = word.find('=');
            if (equals == std::string_view::npos)
                continue;
            const std::string_view key = word.substr(0, equals);
            if (!takeParameter(key, word.substr(equals + 1)))
                return refuse(line, inQuotes(word) + " is not a valid parameter of a turn");
        }
    }

    /// Unknown keys are valid: later versions may add some.
    bool takeParameter(std::string_view key, std::string_view value)
    {
        if (key == "step_deg") {
            const auto step = parseNumber(value);
            m_turn->nominalStep = radFromDeg(step.value_or(0.0));
            return step && isStep(m_turn->nominalStep);
        }
        if (key == "turn_time_ms") {
            const auto time = parseNumber(value);
            m_turn->turnTime_s = time ? std::optional(*time * 1e-3) : std::nullopt;
            return time && isTurnTime_s(*m_turn->turnTime_s);
        }
        if (key == "rotation")
            return (m_turn->rotation = parseRotation(value)).has_value();
        if (key == "kind") {
            const auto kind = parseTurnKind(value);
            m_turn->kind = kind.value_or(TurnKind::Timed);
            return kind.has_value();
        }
        return true;
    }

    void takeStop(int line, const std::vector<std::string_view>& words)
    {
        const bool isRetake = words[0] == "retake";
        const auto stopsSoFar = m_turn ? m_turn->stops.size() : 0;
        const bool hasNumber = words.size() > 1 && words[1].find('=') == std::string_view::npos;
        const auto number =
            hasNumber ? parseInteger(words[1]) : std::optional(static_cast<int>(stopsSoFar) + 1);
        if (!number || *number < 1 || *number > static_cast<int>(mostStops)) {
            if (!m_turn)
                beginTurn(line);
            return refuse(line, "the number of a stop must be from 1 to " + std::to_string(mostStops));
        }
        const auto index = static_cast<std::size_t>(*number - 1);
        if (isRetake && index >= stopsSoFar)
            return refuse(line, "stop " + std::to_string(*number) + " is retaken before it was taken");
        if (!m_turn || (!isRetake && index < stopsSoFar))
            beginTurn(line);
        if (isRetake)
            m_turn->stops[index] = {};
        else
            m_turn->stops.resize(index + 1);
        m_stop = index;
        m_moving = false;
    }

    void takeReaderLine(const TextLine& line)
    {
        const StampedLine stamped = withoutStamp(line.text);
        const auto read =
            m_options.decodeReaderLine ? m_options.decodeReaderLine(stamped.text) : std::nullopt;
        if (!read)
            return;
        TurnStop& stop = m_turn->stops[*m_stop];
        std::vector<TagRead>& reads = m_moving ? stop.movingReads : stop.reads;
        if (reads.size() < mostReadsPerStop)
            reads.push_back({stamped.time, read->uid, read->rssi});
    }

    const TurnFileOptions& m_options;
    std::vector<RecordedTurn> m_turns;
    std::optional<TurnRecord> m_turn;
    std::optional<TurnFileProblem> m_problem;
    int m_firstLine = 0;
    std::optional<std::size_t> m_stop;
    bool m_moving = false;
};

} // namespace

bool isCaptureMark(std::string_view line)
{
    const std::vector<std::string_view> words = wordsOfMark(line);
    return !words.empty() && (words[0] == "turn" || words[0] == "stop" || words[0] == "agv-capture");
}

std::vector<RecordedTurn> readCaptureTurns(const std::vector<TextLine>& lines, const TurnFileOptions& options)
{
    CaptureReader reader(options);
    for (const TextLine& line : lines)
        reader.take(line);
    return reader.finish();
}

} // namespace agv::recording
