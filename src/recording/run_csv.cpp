// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_csv.h"

#include "core/text_file.h"
#include "recording/run_csv_rows.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace agv::recording {
namespace {

constexpr std::size_t bufferBytes = std::size_t{256} * 1024;
constexpr std::uint64_t rowsBetweenLooks = 4096;
constexpr std::size_t largestInfoCopy = std::size_t{1024} * 1024;

std::unexpected<Error> notWritten(const std::filesystem::path& file, int number)
{
    const bool forbidden = number == EACCES || number == EPERM || number == EROFS;
    return failure(forbidden ? ErrorCode::Permission : ErrorCode::Io,
                   file.string() + ": cannot be written (" + std::generic_category().message(number) +
                       "): choose another folder or free some space");
}

/// A file that has its name only after publish(); it vanishes otherwise.
class PartialFile {
public:
    explicit PartialFile(std::filesystem::path target)
        : m_target(std::move(target)),
          m_partial(m_target.string() + ".partial"),
          m_descriptor(::open(m_partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
          m_error(m_descriptor < 0 ? errno : 0)
    {}
    PartialFile(PartialFile&& other) noexcept
        : m_target(std::move(other.m_target)),
          m_partial(std::exchange(other.m_partial, {})),
          m_descriptor(std::exchange(other.m_descriptor, -1)),
          m_error(other.m_error),
          m_buffer(std::move(other.m_buffer))
    {}
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    PartialFile& operator=(PartialFile&&) = delete;
    ~PartialFile()
    {
        if (m_descriptor >= 0)
            ::close(m_descriptor);
        if (!m_partial.empty())
            ::unlink(m_partial.c_str());
    }

    std::string& buffer() { return m_buffer; } ///< text to be appended; flushIfFull() now and then
    bool flushIfFull() { return m_buffer.size() < bufferBytes || flush(); }
    const std::filesystem::path& target() const { return m_target; }
    std::unexpected<Error> error() const { return notWritten(m_target, m_error); }
    bool isBad() const { return m_error != 0; }

    /// Everything is on the disk, still without its name.
    bool complete()
    {
        if (flush() && ::fsync(m_descriptor) == 0 && ::close(std::exchange(m_descriptor, -1)) == 0)
            return true;
        m_error = m_error != 0 ? m_error : errno;
        return false;
    }
    bool publish()
    {
        if (::rename(m_partial.c_str(), m_target.c_str()) != 0) {
            m_error = errno;
            return false;
        }
        m_partial.clear();
        return true;
    }

private:
    bool flush()
    {
        std::string_view rest = m_buffer;
        while (m_error == 0 && !rest.empty()) {
            const ssize_t written = ::write(m_descriptor, rest.data(), rest.size());
            if (written >= 0)
                rest.remove_prefix(static_cast<std::size_t>(written));
            else if (errno != EINTR)
                m_error = errno;
        }
        m_buffer.clear();
        return m_error == 0;
    }

    std::filesystem::path m_target;
    std::filesystem::path m_partial;
    int m_descriptor;
    int m_error;
    std::string m_buffer;
};

/// One export: the files it makes, and how far it is.
class CsvExporter {
public:
    CsvExporter(RunReader& run, std::filesystem::path folder, const CsvProgress& progress)
        : m_run(run),
          m_folder(std::move(folder)),
          m_progress(progress)
    {}

    Result<CsvExport> run()
    {
        Result<void> result = countAll();
        for (std::size_t table = 0; result && table < runTableCount; ++table)
            result = writeTable(table);
        if (result)
            result = writeRaw();
        if (result)
            result = copyInfo();
        for (std::size_t i = 0; result && i < m_files.size(); ++i) {
            if (!m_files[i].publish())
                result = m_files[i].error();
            m_export.files.push_back(m_files[i].target());
        }
        if (!result)
            return std::unexpected(result.error());
        return std::move(m_export);
    }

private:
    Result<void> countAll()
    {
        Result<std::uint64_t> count = m_run.countBlocks();
        for (std::size_t table = 0; count && table < runTableCount; ++table) {
            m_total += *count;
            count = m_run.countRows(table);
        }
        if (!count)
            return std::unexpected(count.error());
        m_total += *count;
        return {};
    }

    Result<void> writeTable(std::size_t table)
    {
        const RunTable& described = runTables()[table];
        PartialFile& file = add(std::string(described.name) + ".csv");
        if (file.isBad())
            return file.error();
        file.buffer() = CsvRowWriter::header(described);
        CsvRowWriter rows(m_run);
        const Result<void> read = m_run.rows(table, [&](const RunReader::Row& row) {
            rows.append(file.buffer(), described, row);
            return file.flushIfFull() && goesOn();
        });
        return ended(read, file);
    }

    Result<void> writeRaw()
    {
        PartialFile& file = add("raw.csv");
        if (file.isBad())
            return file.error();
        file.buffer() = CsvRowWriter::rawHeader();
        CsvRowWriter rows(m_run);
        const Result<void> read = m_run.chunks([&](const RunChunk& chunk) {
            rows.appendRaw(file.buffer(), chunk);
            return file.flushIfFull() && goesOn();
        });
        return ended(read, file);
    }

    Result<void> copyInfo()
    {
        const Result<std::string> info = readTextFile(m_run.folder() / runInfoFile, largestInfoCopy);
        if (!info)
            return std::unexpected(info.error());
        PartialFile& file = add(runInfoFile);
        if (file.isBad())
            return file.error();
        file.buffer() = *info;
        return ended({}, file);
    }

    PartialFile& add(const std::string& name) { return m_files.emplace_back(m_folder / name); }

    Result<void> ended(const Result<void>& read, PartialFile& file)
    {
        if (!read)
            return read;
        if (m_isCancelled)
            return failure(ErrorCode::Cancelled, m_folder.string() + ": the export was cancelled");
        if (file.isBad() || !file.complete())
            return file.error();
        return {};
    }

    bool goesOn()
    {
        if (++m_export.rows % rowsBetweenLooks != 0 || !m_progress)
            return true;
        const double fraction =
            m_total > 0 ? static_cast<double>(m_export.rows) / static_cast<double>(m_total) : 1.0;
        m_isCancelled = !m_progress(fraction < 1.0 ? fraction : 1.0);
        return !m_isCancelled;
    }

    RunReader& m_run;
    std::filesystem::path m_folder;
    const CsvProgress& m_progress;
    std::vector<PartialFile> m_files;
    CsvExport m_export;
    std::uint64_t m_total = 0; ///< rows, and blocks of bytes
    bool m_isCancelled = false;
};

} // namespace

Result<CsvExport> exportCsv(RunReader& run, const std::filesystem::path& folder, const CsvProgress& progress)
{
    std::error_code error;
    const bool isNew = std::filesystem::create_directories(folder, error);
    if (error)
        return notWritten(folder, error.value());
    Result<CsvExport> result = CsvExporter(run, folder, progress).run();
    if (!result && isNew)
        std::filesystem::remove(folder, error); // only what is empty
    return result;
}

} // namespace agv::recording
