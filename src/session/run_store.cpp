// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/run_store.h"

#include <string>
#include <system_error>
#include <vector>

namespace agv::session {
namespace {

constexpr Duration forgetEvery = std::chrono::seconds(20);

QString textOfError(const Error& error) { return QString::fromStdString(error.detail); }

QString folderText(const std::filesystem::path& folder) { return QString::fromStdString(folder.string()); }

} // namespace

void RunStore::beginRun(const RunOrder& order)
{
    auto run = recording::RunWriter::create(order.runs, order.info, order.plant, order.start);
    if (!run) {
        emit runFailed(textOfError(run.error()));
        return;
    }
    m_run.emplace(std::move(*run));
    emit runBegan(folderText(m_run->folder()));
}

void RunStore::endRun(std::int64_t ended_utc_ms)
{
    if (!m_run)
        return;
    const Result<void> finished = m_run->finish(ended_utc_ms);
    const QString folder = folderText(m_run->folder());
    m_run.reset();
    if (finished)
        emit runEnded(folder);
    else
        emit endFailed(textOfError(finished.error()));
}

/// The rings of consoles that have ended; the last one stays. One whose console runs is locked.
void RunStore::putAside(const std::filesystem::path& runs)
{
    std::error_code error;
    std::vector<std::filesystem::path> rings;
    for (const auto& entry : std::filesystem::directory_iterator(runs, error)) {
        if (entry.path().filename().string().starts_with(ringName))
            rings.push_back(entry.path());
    }
    for (const std::filesystem::path& ring : rings) {
        const Result<recording::RunLock> lock = recording::RunLock::take(ring);
        if (!lock)
            continue;
        std::filesystem::remove_all(runs / earlierRingName, error);
        std::filesystem::rename(ring, runs / earlierRingName, error);
    }
}

void RunStore::beginRing(const RunOrder& order, Duration keptFor)
{
    putAside(order.runs);
    auto ring = recording::RunWriter::create(order.runs, order.info, order.plant, order.start, ringName);
    if (!ring) {
        emit ringFailed(textOfError(ring.error()));
        return;
    }
    m_ring.emplace(std::move(*ring));
    m_keptFor = keptFor;
    m_forgotten = order.start.time;
    emit ringBegan();
}

void RunStore::keep(const RunOrder& order, Time since)
{
    if (!m_ring) {
        emit keepFailed(QStringLiteral("nothing was recorded yet"));
        return;
    }
    const auto folder = m_ring->keep(order.runs, order.info, order.plant, since);
    if (folder)
        emit kept(folderText(*folder));
    else
        emit keepFailed(textOfError(folder.error()));
}

void RunStore::append(const std::shared_ptr<const recording::RunBatch>& batch)
{
    if (m_run) {
        if (const Result<void> appended = m_run->append(*batch); !appended) {
            m_run.reset();
            emit runFailed(textOfError(appended.error()));
        }
    }
    appendToRing(*batch);
    emit appended(batch->bytes, m_run ? m_run->bytesOnDisk() : 0);
}

void RunStore::appendToRing(const recording::RunBatch& batch)
{
    if (!m_ring)
        return;
    Result<void> result = m_ring->append(batch);
    if (result && batch.clocks.time - m_forgotten >= forgetEvery) {
        m_forgotten = batch.clocks.time;
        result = m_ring->forget(batch.clocks.time - m_keptFor);
    }
    if (result)
        return;
    m_ring.reset();
    emit ringFailed(textOfError(result.error()));
}

} // namespace agv::session
