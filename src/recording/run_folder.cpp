// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_folder.h"

#include "core/text_file.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace agv::recording {
namespace {

using InfoJson = nlohmann::ordered_json;
constexpr std::size_t largestRunInfo = std::size_t{1024} * 1024;

std::unexpected<Error> noFolder(const std::filesystem::path& folder, const std::error_code& reason)
{
    const bool forbidden = reason == std::errc::permission_denied ||
                           reason == std::errc::read_only_file_system ||
                           reason == std::errc::operation_not_permitted;
    return failure(forbidden ? ErrorCode::Permission : ErrorCode::Io,
                   folder.string() + ": the folder of the run cannot be made (" + reason.message() +
                       "): choose another folder");
}

std::tm utcParts(std::int64_t utc_ms)
{
    const std::time_t seconds = static_cast<std::time_t>(utc_ms >= 0 ? utc_ms / 1000 : (utc_ms - 999) / 1000);
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    return parts;
}

std::string formatted(std::int64_t utc_ms, const char* format)
{
    const std::tm parts = utcParts(utc_ms);
    std::string text(40, '\0');
    text.resize(std::strftime(text.data(), text.size(), format, &parts));
    return text;
}

/// The value of a key that must be there and be of its type.
template<typename T>
T wanted(const InfoJson& json, const char* key)
{
    return json.at(key).get<T>();
}

RunInfo infoFrom(const InfoJson& json)
{
    RunInfo info;
    info.format = wanted<int>(json, "format");
    info.software = wanted<std::string>(json, "software");
    info.started_utc_ms = wanted<std::int64_t>(json, "started_utc_ms");
    if (const InfoJson& ended = json.at("ended_utc_ms"); !ended.is_null())
        info.ended_utc_ms = ended.get<std::int64_t>();
    info.startedBy = wanted<std::string>(json, "started_by");
    info.note = wanted<std::string>(json, "note");
    info.plantName = wanted<std::string>(json, "plant_name");
    info.plantFile = wanted<std::string>(json, "plant_file");
    info.agvs = wanted<std::vector<int>>(json, "agvs");
    info.simulated = wanted<bool>(json, "simulated");
    info.solverSeed = wanted<std::uint64_t>(json, "solver_seed");
    info.solver = wanted<std::string>(json, "solver");
    return info;
}

InfoJson jsonFromInfo(const RunInfo& info)
{
    const auto ended = info.ended_utc_ms;
    return {{"format", info.format},
            {"software", info.software},
            {"started", utcText(info.started_utc_ms)},
            {"started_utc_ms", info.started_utc_ms},
            {"ended", ended ? InfoJson(utcText(*ended)) : InfoJson()},
            {"ended_utc_ms", ended ? InfoJson(*ended) : InfoJson()},
            {"started_by", info.startedBy},
            {"note", info.note},
            {"plant_name", info.plantName},
            {"plant_file", info.plantFile},
            {"plant_copy", runPlantFile},
            {"agvs", info.agvs},
            {"simulated", info.simulated},
            {"solver_seed", info.solverSeed},
            {"solver", info.solver}};
}

} // namespace

Result<RunInfo> readRunInfo(const std::filesystem::path& run)
{
    const std::filesystem::path file = run / runInfoFile;
    const Result<std::string> text = readTextFile(file, largestRunInfo);
    if (!text)
        return std::unexpected(text.error());
    try {
        RunInfo info = infoFrom(InfoJson::parse(*text));
        if (info.format > runFormat)
            return failure(ErrorCode::BadInput, file.string() + ": the run is of a newer version (" +
                                                    info.software + "): use that one to read it");
        return info;
    } catch (const nlohmann::json::exception& problem) {
        return failure(ErrorCode::BadInput, file.string() + ": is damaged or of no run (" + problem.what() +
                                                "): use a copy of it, if there is one");
    }
}

Result<void> writeRunInfo(const std::filesystem::path& run, const RunInfo& info)
{
    // Notes and file names may hold any bytes; what is no UTF-8 is replaced.
    return writeTextFile(run / runInfoFile,
                         jsonFromInfo(info).dump(2, ' ', false, InfoJson::error_handler_t::replace) + "\n");
}

std::string utcText(std::int64_t utc_ms)
{
    const auto milliseconds = static_cast<int>(((utc_ms % 1000) + 1000) % 1000);
    std::string text = formatted(utc_ms, "%Y-%m-%dT%H:%M:%S.");
    for (const int place : {100, 10, 1})
        text += static_cast<char>('0' + milliseconds / place % 10);
    return text + "Z";
}

std::string runName(std::int64_t utc_ms) { return formatted(utc_ms, "%Y%m%dT%H%M%SZ"); }

Result<std::filesystem::path> makeRunFolder(const std::filesystem::path& parent, const std::string& name)
{
    constexpr int mostOfOneSecond = 1000;
    std::error_code error;
    std::filesystem::create_directories(parent, error);
    if (error)
        return noFolder(parent, error);
    for (int number = 1; number <= mostOfOneSecond; ++number) {
        auto folder = parent / (number == 1 ? name : name + "-" + std::to_string(number));
        if (std::filesystem::create_directory(folder, error))
            return folder;
        if (error)
            return noFolder(folder, error);
    }
    return noFolder(parent / name, std::make_error_code(std::errc::file_exists));
}

Result<RunLock> RunLock::take(const std::filesystem::path& run)
{
    const std::filesystem::path file = run / runLockFile;
    RunLock lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (lock.m_descriptor < 0)
        return noFolder(run, {errno, std::generic_category()});
    if (::flock(lock.m_descriptor, LOCK_EX | LOCK_NB) != 0)
        return failure(ErrorCode::InUse,
                       run.string() + ": another console records into this run: close that one");
    return lock;
}

RunLock& RunLock::operator=(RunLock&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

RunLock::~RunLock()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

} // namespace agv::recording
