// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve_turn.h"

#include "app/tag_fields.h"
#include "core/plant_file.h"
#include "core/text_file.h"
#include "estimation/turn_solver.h"
#include "protocol/reader_line.h"
#include "recording/emulator_setup.h"
#include "recording/turn_file.h"
#include "recording/turn_results.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <ostream>
#include <thread>
#include <unistd.h>
#include <unordered_set>

namespace agv::app {

namespace {

using estimation::TurnContext;
using recording::RecordedTurn;
using recording::TurnFile;
using recording::TurnFileOptions;
using recording::TurnResult;

constexpr std::size_t turnsAtATime = 32; ///< rows come out while a long file is being solved
constexpr std::string_view standardInput = "-";

enum ExitStatus { allSolved = 0, someFailed = 1, wrongUsage = 2 };

std::optional<recording::ReaderLineRead> decodeLine(std::string_view line)
{
    const auto report = protocol::decodeReaderLine(line);
    const auto* read = report ? std::get_if<protocol::CompleteRead>(&*report) : nullptr;
    return read ? std::optional(recording::ReaderLineRead{read->uid, read->rssi}) : std::nullopt;
}

std::optional<std::string> whyUsageIsWrong(const SolveTurnArguments& arguments)
{
    if (arguments.files.empty())
        return "name at least one file of turns";
    if (arguments.plantFile && arguments.field)
        return "--plant and --field exclude each other";
    if (arguments.robot && !arguments.plantFile)
        return "--robot needs --plant";
    if (!(arguments.pitch_mm > 0.0 && arguments.pitch_mm <= 10'000.0))
        return "--pitch must be over 0 and up to 10000 mm";
    if (!(arguments.turnTime_ms >= leastSleeptime_ms && arguments.turnTime_ms <= mostSleeptime_ms))
        return "--turn-time must be from " + std::to_string(leastSleeptime_ms) + " to " +
               std::to_string(mostSleeptime_ms) + " ms";
    if (!(arguments.step_deg >= 1.0 && arguments.step_deg <= 180.0))
        return "--step must be from 1 to 180 degrees";
    if (arguments.field) {
        const auto tags = parseField(*arguments.field, metresFromMm(arguments.pitch_mm));
        if (!tags)
            return tags.error().detail;
    }
    return std::nullopt;
}

/// Why nothing is solved.
struct Refusal {
    ExitStatus status;
    std::string text;
};

/// What the plant file or the field says; nothing when each file must be asked.
std::expected<std::optional<TurnContext>, Refusal> givenContext(const SolveTurnArguments& arguments)
{
    if (arguments.field) {
        TurnContext context;
        context.tags = parseField(*arguments.field, metresFromMm(arguments.pitch_mm)).value();
        return context;
    }
    if (!arguments.plantFile)
        return std::nullopt;
    const auto plant = readPlantFile(*arguments.plantFile);
    if (!plant)
        return std::unexpected(Refusal{someFailed, plant.error().detail});
    const AgvConfig* const agv = arguments.robot       ? plant->findAgv(*arguments.robot)
                                 : plant->agvs.empty() ? nullptr
                                                       : &plant->agvs.front();
    if (arguments.robot && !agv)
        return std::unexpected(Refusal{wrongUsage, *arguments.plantFile + ": has no AGV " +
                                                       std::to_string(arguments.robot->number)});
    return estimation::contextFor(*plant, agv ? *agv : AgvConfig{});
}

/// Files by their names, and standard input by its own. Reads each once: a pipe cannot be read again when its
/// turns have to be parsed with other tags.
class TurnSource {
public:
    explicit TurnSource(std::istream& in) : m_in(in) {}

    Result<TurnFile> read(const std::string& path, const TurnFileOptions& options)
    {
        const Result<std::string>& text = textOf(path);
        if (!text)
            return std::unexpected(text.error());
        auto file = recording::parseTurns(*text, options);
        if (!file)
            file.error().detail = path + ": " + file.error().detail;
        return file;
    }

private:
    const Result<std::string>& textOf(const std::string& path)
    {
        if (path == standardInput) {
            if (!m_inputText)
                m_inputText = readTextStream(m_in, path, recording::largestTurnFile);
            return *m_inputText;
        }
        if (path != m_path) {
            m_path = path;
            m_text = readTextStream(path, recording::largestTurnFile);
        }
        return m_text;
    }

    std::istream& m_in;
    std::optional<Result<std::string>> m_inputText;
    std::optional<std::string> m_path; ///< of the file read last
    Result<std::string> m_text;
};

/// A file and the tags its turns are solved with.
struct Job {
    TurnFile file;
    TurnContext context;
    std::string assumedField; ///< when nobody said which one
};

bool hasOnlyTagsOf(const TurnFile& file, const std::vector<FloorTag>& tags)
{
    std::unordered_set<TagUid> known;
    for (const FloorTag& tag : tags)
        known.insert(tag.uid);
    bool anyTurn = false;
    for (const RecordedTurn& turn : file.turns) {
        if (!turn.record)
            continue;
        anyTurn = true;
        for (const TurnStop& stop : turn.record->stops) {
            if (!std::ranges::all_of(stop.reads,
                                     [&](const TagRead& read) { return known.contains(read.uid); }))
                return false;
        }
    }
    return anyTurn;
}

Result<Job> openWithTags(TurnSource& source, const std::string& path, TurnFileOptions options,
                         TurnContext context, std::string assumed)
{
    options.tags = context.tags;
    auto file = source.read(path, options);
    if (!file)
        return std::unexpected(file.error());
    return Job{std::move(*file), std::move(context), std::move(assumed)};
}

Result<Job> openGuessingTags(TurnSource& source, const std::string& path, const TurnFileOptions& options)
{
    TurnContext context;
    if (const auto setup = recording::findEmulatorSetup(path)) {
        if (auto tags = recording::fieldOf(*setup, TagUid{0xE004000000000001})) {
            context.tags = std::move(*tags);
            return openWithTags(source, path, options, context,
                                "the " + std::to_string(setup->tags) + " tags of the side file");
        }
    }
    context.tags = seedTestField();
    auto small = openWithTags(source, path, options, context, "the 3x3 test field");
    if (!small || hasOnlyTagsOf(small->file, context.tags))
        return small;
    context.tags = parseField("11x11", metresFromMm(100.0)).value();
    return openWithTags(source, path, options, context, "the 11x11 field at 100 mm");
}

TurnResult solveOne(const Job& job, std::size_t turn, const std::string& path,
                    const SolveTurnArguments& arguments)
{
    const std::string id = path + ":" + std::to_string(turn + 1);
    const auto& record = job.file.turns[turn].record;
    if (!record)
        return recording::unreadableTurn(id, arguments.method,
                                         "line " + std::to_string(record.error().line) + ": " +
                                             record.error().reason);
    estimation::SolveOptions options;
    options.method = arguments.method;
    options.seed = arguments.seed;
    return {id, estimation::solveTurn(*record, job.context, options), {}};
}

/// The turns from `first` on, at most `count` of them, on every core.
std::vector<TurnResult> solveSome(const Job& job, std::size_t first, std::size_t count,
                                  const std::string& path, const SolveTurnArguments& arguments)
{
    std::vector<TurnResult> results(std::min(count, job.file.turns.size() - first));
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < results.size(); i = next++)
            results[i] = solveOne(job, first + i, path, arguments);
    };
    const std::size_t helpers =
        std::min<std::size_t>(results.size(), std::max(1U, std::thread::hardware_concurrency())) - 1;
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < helpers; ++i)
        threads.emplace_back(work);
    work();
    threads.clear();
    return results;
}

/// Where the rows go.
class Output {
public:
    Output(const SolveTurnArguments& arguments, std::ostream& out) : m_arguments(arguments), m_out(out)
    {
        if (arguments.csvFile)
            m_csv = recording::csvHeader();
        else if (!arguments.json)
            m_out << recording::csvHeader();
    }

    void write(const TurnResult& result)
    {
        if (m_arguments.csvFile)
            m_csv += recording::csvRow(result);
        if (m_arguments.json)
            m_out << recording::jsonLine(result);
        else if (!m_arguments.csvFile)
            m_out << recording::csvRow(result);
    }

    /// False when nobody gets the rows any more; then solving on is in vain.
    bool flush()
    {
        if (m_flushed)
            m_flushed = flushStandardOutput(m_out);
        return m_flushed.has_value();
    }

    Result<void> finish()
    {
        flush();
        return m_flushed && m_arguments.csvFile ? writeTextFile(*m_arguments.csvFile, m_csv) : m_flushed;
    }

private:
    const SolveTurnArguments& m_arguments;
    std::ostream& m_out;
    Result<void> m_flushed;
    std::string m_csv;
};

/// Names on `err` what is wrong with a turn; true when nothing is.
bool report(const std::string& path, std::size_t number, const RecordedTurn& turn, const TurnResult& result,
            std::ostream& err)
{
    if (!turn.record)
        err << path << ":" << turn.record.error().line << ": " << turn.record.error().reason << "\n";
    else if (!result.estimate.valid)
        err << path << ":" << turn.line << ": turn " << number << " has no pose: " << result.estimate.status
            << "\n";
    return result.estimate.valid;
}

/// Solves and writes the turns of one file. True when each has a pose.
bool solveAll(const Job& job, const std::string& path, const SolveTurnArguments& arguments, Output& output,
              std::ostream& err)
{
    bool allHavePoses = true;
    for (std::size_t first = 0; first < job.file.turns.size(); first += turnsAtATime) {
        std::size_t turn = first;
        for (const TurnResult& result : solveSome(job, first, turnsAtATime, path, arguments)) {
            output.write(result);
            allHavePoses = report(path, turn + 1, job.file.turns[turn], result, err) && allHavePoses;
            ++turn;
        }
        if (!output.flush())
            return false;
    }
    return allHavePoses;
}

} // namespace

int runSolveTurn(const SolveTurnArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err)
{
    if (const auto why = whyUsageIsWrong(arguments)) {
        err << "solve-turn: " << *why << "\n";
        return wrongUsage;
    }
    if (arguments.csvFile) { // known before hours of solving, not after
        if (const Result<void> writable = checkWritable(*arguments.csvFile); !writable) {
            err << writable.error().detail << "; nothing was solved\n";
            return someFailed;
        }
    }
    const auto given = givenContext(arguments);
    if (!given) {
        err << given.error().text << "\n";
        return given.error().status;
    }
    TurnFileOptions options;
    options.nominalStep = radFromDeg(arguments.step_deg);
    options.turnTime_s = arguments.turnTime_ms * 1e-3;
    options.decodeReaderLine = decodeLine;

    int status = allSolved;
    Output output(arguments, out);
    TurnSource source(in);
    for (const std::string& path : arguments.files) {
        const auto job = *given ? openWithTags(source, path, options, **given, {})
                                : openGuessingTags(source, path, options);
        if (!job || job->file.turns.empty()) {
            err << (job ? path + ": holds no turns" : job.error().detail) << "\n";
            status = someFailed;
            continue;
        }
        if (!job->assumedField.empty())
            err << path << ": neither --plant nor --field was given; taking " << job->assumedField << "\n";
        if (!solveAll(*job, path, arguments, output, err))
            status = someFailed;
        if (!output.flush())
            break;
    }
    if (const auto written = output.finish(); !written) {
        err << written.error().detail << "\n";
        status = someFailed;
    }
    return status;
}

} // namespace agv::app
