// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate.h"

#include "app/locate_output.h"
#include "app/locate_setup.h"
#include "core/text_file.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <map>
#include <ostream>
#include <thread>

namespace agv::app {

namespace {

enum ExitStatus { allLocated = 0, someFailed = 1, wrongUsage = 2 };

using Fixes = Result<std::vector<ReportFix>>;

/// Locates one file after the other and gathers what is written at the end.
class LocateCommand {
public:
    LocateCommand(const LocateArguments& arguments, const LocateSetup& setup, std::istream& in,
                  std::ostream& err)
        : m_arguments(arguments),
          m_setup(setup),
          m_in(in),
          m_err(err)
    {
        std::vector<std::string> titles{"file", "method"};
        if (arguments.by)
            titles.push_back(*arguments.by);
        std::ranges::move(ErrorRow::titles(arguments.inSpace), std::back_inserter(titles));
        m_errors.add(std::move(titles));
    }

    /// False when some of it could not be used.
    bool locate(const std::string& path)
    {
        auto file = readRanges(path, m_in);
        if (!file)
            return refuse(file.error());
        report(path, file->table.problems, m_err);
        const auto anchors = anchorsFor(*file, path);
        if (!anchors)
            return refuse(anchors.error());
        std::optional<TruthIndex> truth;
        if (m_setup.truth) {
            auto index = TruthIndex::make(*m_setup.truth, file->table);
            if (!index)
                return refuse(inFile(*m_arguments.truthFile, index.error()));
            truth = std::move(*index);
        }
        const auto located = locateRanges(path, file->table, *anchors, truth ? &*truth : nullptr);
        return located ? *located && file->table.problems.empty() : refuse(located.error());
    }

    /// Floor tags alone: a position for each time when some were read.
    bool locateFloorReads(const std::string& path)
    {
        const recording::RangeTable noRanges;
        std::optional<TruthIndex> truth;
        if (m_setup.truth) {
            auto index = TruthIndex::make(*m_setup.truth, noRanges);
            if (!index)
                return refuse(inFile(*m_arguments.truthFile, index.error()));
            truth = std::move(*index);
        }
        ReportList moments{.reports = {}, .groupColumns = {}, .tracks = 1};
        for (const FloorFix& fix : m_setup.vehicle->floorFixes)
            moments.reports.push_back({.time_s = fix.time_s, .tag = -1, .track = 0, .rows = {}});
        if (moments.reports.empty())
            return refuse({ErrorCode::BadInput, path + ": no tag that was read has a known place"});
        const PreparedRanges none = PreparedRanges::none(std::move(moments));
        const MethodSettings settings{
            .anchors = {}, .heights_m = {m_arguments.height_m.value_or(0.0)}, .seed = m_arguments.seed};
        const auto located = runAndAdd(path, noRanges, none, none, settings, truth ? &*truth : nullptr);
        return located ? *located : refuse(located.error());
    }

    const PositionCsv& positions() const { return m_positions; }
    std::string errorTable() const
    {
        return "Errors in mm, availability in %, rate in Hz.\n" + m_errors.text(m_arguments.by ? 3 : 2);
    }

private:
    bool refuse(const Error& error)
    {
        m_err << error.detail << "\n";
        return false;
    }

    Result<AnchorSet> anchorsFor(const recording::RangeFile& file, const std::string& path)
    {
        if (m_setup.anchors)
            return *m_setup.anchors;
        if (file.anchors.empty())
            return failure(ErrorCode::NotFound,
                           path + ": the places of the anchors are not known; give --anchors or --plant");
        m_err << path << ": neither --anchors nor --plant was given; taking the " << file.anchors.size()
              << " anchors of the log\n";
        return AnchorSet{file.anchors, {}};
    }

    /// Heights of the tags by track: as given, as the truth says, or 0.
    std::vector<double> heightsOf(const recording::RangeTable& table, const ReportList& list,
                                  const TruthIndex* truth, const std::string& path)
    {
        std::vector<double> heights(list.tracks, m_arguments.height_m.value_or(0.0));
        if (m_arguments.height_m || m_arguments.inSpace)
            return heights;
        bool fromTruth = false;
        std::vector<bool> known(list.tracks);
        for (const UwbReport& moment : list.reports) {
            if (truth == nullptr || known[moment.track])
                continue;
            const auto place = truth->at(table, moment.rows.front(), moment.time_s);
            if (!place || !place->z_m)
                continue;
            heights[moment.track] = *place->z_m;
            known[moment.track] = fromTruth = true;
        }
        m_err << path << ": --height was not given; taking "
              << (fromTruth ? "the height of the truth" : "tags on the floor, 0 m") << "\n";
        return heights;
    }

    Result<bool> locateRanges(const std::string& path, const recording::RangeTable& table,
                              const AnchorSet& anchors, const TruthIndex* truth)
    {
        const ReportList single =
            groupReports(table, m_setup.truth ? m_setup.truth->otherColumns : std::vector<std::string>());
        if (single.reports.empty())
            return failure(ErrorCode::BadInput, path + ": has no range between a tag and an anchor");
        const bool inTurns = comesInTurns(single);
        const auto* const calibration = m_setup.calibration ? &*m_setup.calibration : nullptr;
        const auto prepare = [&](ReportList list) {
            return PreparedRanges::make(table, std::move(list), anchors, calibration, path);
        };
        const auto singles = prepare(single);
        if (!singles)
            return std::unexpected(singles.error());
        std::optional<PreparedRanges> rounds;
        if (inTurns) {
            auto prepared = prepare(roundsOf(table, single));
            if (!prepared)
                return std::unexpected(prepared.error());
            rounds = std::move(*prepared);
        }
        const PreparedRanges& whole = rounds ? *rounds : *singles;
        noteRanges(path, *singles, inTurns);
        if (singles->usedRanges() == 0)
            return failure(ErrorCode::BadInput, path + ": no range belongs to an anchor of the list");

        MethodSettings settings{
            .anchors = {}, .heights_m = heightsOf(table, single, truth, path), .seed = m_arguments.seed};
        for (const UwbAnchor& anchor : anchors.anchors)
            settings.anchors.emplace_back(anchor.x, anchor.y, anchor.z);
        return runAndAdd(path, table, *singles, whole, settings, truth);
    }

    /// False when a method has no position.
    Result<bool> runAndAdd(const std::string& path, const recording::RangeTable& table,
                           const PreparedRanges& singles, const PreparedRanges& whole,
                           const MethodSettings& settings, const TruthIndex* truth)
    {
        const std::vector<Fixes> results = runAll(singles, whole, settings);
        bool allHavePositions = true;
        for (std::size_t k = 0; k < results.size(); ++k) {
            if (!results[k])
                return std::unexpected(results[k].error());
            const std::string_view method = m_setup.methods[k];
            const PreparedRanges& ranges = takesSingles(method) ? singles : whole;
            if (!add(path, method, table, ranges.list(), *results[k], truth))
                allHavePositions = false;
        }
        return allHavePositions;
    }

    void noteRanges(const std::string& path, const PreparedRanges& ranges, bool inTurns)
    {
        for (const auto& [anchor, count] : ranges.unknownAnchors())
            m_err << path << ": anchor " << anchor << " is not in the list; its " << count
                  << " ranges are left out\n";
        if (ranges.uncalibrated() > 0)
            m_err << path << ": " << ranges.uncalibrated()
                  << " ranges are of pairs of tag and anchor that were not calibrated\n";
        if (m_setup.calibration && m_setup.calibration->judgesItself(path))
            m_err << path << ": is calibrated on itself; its errors say little\n";
        if (inTurns && !std::ranges::all_of(m_setup.methods, takesSingles))
            m_err << path << ": the anchors answer in turns; a report is a round of them\n";
    }

    /// Tight fusion takes every single range when it comes; the others need a round.
    static bool takesSingles(std::string_view method) { return method == "fusion"; }

    /// Every method, on every core.
    std::vector<Fixes> runAll(const PreparedRanges& singles, const PreparedRanges& whole,
                              const MethodSettings& settings) const
    {
        const std::vector<std::string_view>& methods = m_setup.methods;
        std::vector<Fixes> results(methods.size());
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t k = next++; k < methods.size(); k = next++)
                results[k] = runMethod(methods[k], takesSingles(methods[k]) ? singles : whole, settings,
                                       m_setup.vehicle ? &*m_setup.vehicle : nullptr);
        };
        std::vector<std::jthread> helpers;
        const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
        for (std::size_t k = 1; k < std::min(methods.size(), cores); ++k)
            helpers.emplace_back(work);
        work();
        helpers.clear();
        return results;
    }

    /// The value of --by.
    std::string groupOf(const recording::RangeTable& table, const UwbReport& moment,
                        const std::optional<TrueAt>& truth) const
    {
        if (const auto column = table.extraColumn(*m_arguments.by))
            return valueOf(table, moment, *column);
        if (*m_arguments.by == "tag")
            return moment.tag >= 0 ? std::to_string(moment.tag) : std::string();
        const auto column = m_setup.truth->otherColumn(*m_arguments.by);
        return truth && column ? truth->row->columns[*column] : std::string();
    }

    /// True when there is any position.
    bool add(const std::string& path, std::string_view method, const recording::RangeTable& table,
             const ReportList& list, const std::vector<ReportFix>& fixes, const TruthIndex* truth)
    {
        const bool wantsRows = m_arguments.csvFile || !m_arguments.truthFile;
        std::vector<std::pair<std::string, ErrorRow>> rows; // in the order of the file
        std::map<std::string, std::size_t> places;
        estimation::FixStatus lastStatus{};
        bool any = false;
        for (std::size_t k = 0; k < fixes.size(); ++k) {
            const UwbReport& moment = list.reports[k];
            Outcome outcome{moment, fixes[k], {}};
            if (truth != nullptr)
                outcome.truth = moment.rows.empty() ? truth->at(moment.time_s)
                                                    : truth->at(table, moment.rows.front(), moment.time_s);
            const std::string group = m_arguments.by ? groupOf(table, moment, outcome.truth) : std::string();
            const auto [place, isNew] = places.try_emplace(group, rows.size());
            if (isNew)
                rows.emplace_back(group, ErrorRow(m_arguments.inSpace, truth != nullptr));
            rows[place->second].second.add(outcome);
            if (wantsRows)
                m_positions.add(path, method, table, outcome);
            any = any || fixes[k].ok();
            lastStatus = fixes[k].status;
        }
        for (const auto& [group, row] : rows) {
            std::vector<std::string> cells{path, std::string(method)};
            if (m_arguments.by)
                cells.push_back(group.empty() ? "-" : group);
            std::ranges::move(row.cells(), std::back_inserter(cells));
            m_errors.add(std::move(cells));
        }
        if (!any)
            m_err << path << ": " << method << " has no position: " << estimation::toText(lastStatus) << "\n";
        return any || m_setup.methods.size() > 1;
    }

    const LocateArguments& m_arguments;
    const LocateSetup& m_setup;
    std::istream& m_in;
    std::ostream& m_err;
    TextTable m_errors;
    PositionCsv m_positions;
};

Result<void> write(const LocateArguments& arguments, const LocateCommand& command, std::ostream& out)
{
    const std::string positions = arguments.csvFile || !arguments.truthFile
                                      ? command.positions().text(arguments.truthFile.has_value())
                                      : std::string();
    if (arguments.csvFile || arguments.truthFile)
        out << command.errorTable();
    else
        out << positions;
    if (const auto flushed = flushStandardOutput(out); !flushed)
        return flushed;
    return arguments.csvFile ? writeTextFile(*arguments.csvFile, positions) : Result<void>();
}

} // namespace

int runLocate(const LocateArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err)
{
    const char* const name = arguments.fuse ? "fuse" : "locate";
    if (const auto why = whyUsageIsWrong(arguments)) {
        err << name << ": " << *why << "\n";
        return wrongUsage;
    }
    const auto fail = [&](const Error& error) {
        err << error.detail << "\n";
        return someFailed;
    };
    if (arguments.listMethods) {
        out << methodTable();
        const auto flushed = flushStandardOutput(out);
        return flushed ? allLocated : fail(flushed.error());
    }
    if (arguments.csvFile) // known before long computing, not after
        if (const auto writable = checkWritable(*arguments.csvFile); !writable)
            return fail({writable.error().code, writable.error().detail + "; nothing was located"});
    const auto setup = readSetup(arguments, err);
    if (!setup)
        return fail(setup.error());

    int status = setup->someBad ? someFailed : allLocated;
    LocateCommand command(arguments, *setup, in, err);
    if (arguments.inputs.empty() && !command.locateFloorReads(*arguments.floorFile))
        status = someFailed;
    for (const std::string& input : arguments.inputs) {
        const auto files = filesOf(input);
        if (!files) {
            status = fail(files.error());
            continue;
        }
        for (const std::string& file : *files)
            if (!command.locate(file))
                status = someFailed;
    }
    if (const auto written = write(arguments, command, out); !written)
        status = fail(written.error());
    return status;
}

} // namespace agv::app
