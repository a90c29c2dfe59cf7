// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/run_recorder.h"

#include "session/wall_clock.h"

#include <algorithm>
#include <utility>

namespace agv::session {
namespace {

/// More than this is handed over before its time.
constexpr std::size_t largestBatch = std::size_t{1} << 20;

recording::ClockPair clocksNow() { return {monotonicNow(), utcNow_us()}; }

} // namespace

RunRecorder::RunRecorder(RecordingOptions options, EventLog& events, QObject* parent)
    : QObject(parent),
      m_options(std::move(options)),
      m_events(events),
      m_store(new RunStore),
      m_timer(new QTimer(this))
{
    m_thread.setObjectName("recording");
    m_store->moveToThread(&m_thread);
    m_timer->setInterval(batchTime);
    connect(m_timer, &QTimer::timeout, this, &RunRecorder::flush);
    wireStore();
}

RunRecorder::~RunRecorder()
{
    m_store->disconnect(this);
    if (m_thread.isRunning()) {
        flush();
        tell([ended = utcNow_us() / 1000](RunStore& store) { store.endRun(ended); });
        tell([thread = &m_thread](RunStore&) { thread->quit(); });
        m_thread.wait();
    }
    delete m_store;
}

template<typename Call>
void RunRecorder::tell(Call call)
{
    QMetaObject::invokeMethod(
        m_store, [store = m_store, call = std::move(call)] { call(*store); }, Qt::QueuedConnection);
}

void RunRecorder::wireStore()
{
    connect(m_store, &RunStore::runBegan, this, [this](const QString& folder) {
        m_shown.folder = folder.toStdString();
        log(EventLevel::Info, QStringLiteral("Recording into %1").arg(folder));
    });
    connect(m_store, &RunStore::runEnded, this, [this](const QString& folder) {
        log(EventLevel::Info, QStringLiteral("The recording is in %1").arg(folder));
    });
    connect(m_store, &RunStore::endFailed, this, [this](const QString& reason) {
        log(EventLevel::Error, QStringLiteral("The end of the recording is not written: %1").arg(reason));
    });
    connect(m_store, &RunStore::runFailed, this, &RunRecorder::fail);
    connect(m_store, &RunStore::ringBegan, this, [this] { emit changed(); });
    connect(m_store, &RunStore::ringFailed, this, [this](const QString& reason) {
        m_hasRing = false;
        log(EventLevel::Warning, QStringLiteral("The last minutes are no longer kept: %1").arg(reason));
    });
    connect(m_store, &RunStore::kept, this, [this](const QString& folder) {
        log(EventLevel::Info, QStringLiteral("The last minutes are kept in %1").arg(folder));
    });
    connect(m_store, &RunStore::keepFailed, this, [this](const QString& reason) {
        log(EventLevel::Error, QStringLiteral("The last minutes are not kept: %1").arg(reason));
    });
    connect(m_store, &RunStore::appended, this, [this](quint64 batchBytes, quint64 runBytes) {
        m_pending -= std::min(m_pending, static_cast<std::size_t>(batchBytes));
        if (m_isRunning && runBytes > 0)
            m_shown.bytes = runBytes;
        emit changed();
    });
}

void RunRecorder::begin(const PlantLayout& plant, bool simulated, std::uint64_t solverSeed,
                        SolveMethod method)
{
    m_plant = plant;
    m_info.software = m_options.software;
    m_info.plantName = plant.name;
    m_info.plantFile = m_options.plantFile;
    for (const AgvConfig& agv : plant.agvs)
        m_info.agvs.push_back(agv.id.number);
    m_info.simulated = simulated;
    m_info.solverSeed = solverSeed;
    m_info.solver = toText(method);
    if (m_options.runs.empty())
        return;
    m_thread.start(QThread::LowPriority);
    if (!m_options.ring)
        return;
    m_hasRing = true;
    tell([ring = order("always on", {}), keptFor = m_options.ringFor](RunStore& store) {
        store.beginRing(ring, keptFor);
    });
    m_timer->start();
}

RunOrder RunRecorder::order(const std::string& startedBy, const std::string& note) const
{
    RunOrder order{m_options.runs, m_info, m_plant, clocksNow()};
    order.info.startedBy = startedBy;
    order.info.note = note;
    return order;
}

void RunRecorder::start(const std::string& startedBy, const std::string& note)
{
    if (m_isRunning)
        return;
    if (!m_thread.isRunning()) {
        fail(QStringLiteral("there is no folder for recordings"));
        return;
    }
    flush(); // what came before belongs to the ring only
    const RunOrder run = order(startedBy, note);
    m_isRunning = true;
    m_started = run.start.time;
    m_shown = {};
    m_shown.state = RecordingState::Recording;
    tell([run](RunStore& store) { store.beginRun(run); });
    m_timer->start();
    emit began();
    emit changed();
}

void RunRecorder::stop()
{
    if (!m_isRunning)
        return;
    flush();
    tell([ended = utcNow_us() / 1000](RunStore& store) { store.endRun(ended); });
    m_isRunning = false;
    m_shown.state = RecordingState::Off;
    m_shown.elapsed_s = secondsFrom(monotonicNow() - m_started);
    if (!isListening())
        m_timer->stop();
    emit changed();
}

void RunRecorder::keepRecent()
{
    if (!m_hasRing) {
        log(EventLevel::Error,
            QStringLiteral("The last minutes are not kept: they were not recorded, see the log"));
        return;
    }
    flush();
    tell([run = order("kept", {}), since = monotonicNow() - keptMinutes](RunStore& store) {
        store.keep(run, since);
    });
}

void RunRecorder::chunk(const std::string& link, const link::Chunk& chunk)
{
    if (!isListening())
        return;
    m_batch.chunks.push_back({chunk.time, link, chunk.bytes.toStdString()});
    m_batch.bytes += sizeof(recording::RunChunk) + static_cast<std::size_t>(chunk.bytes.size());
    if (m_batch.bytes > largestBatch)
        flush();
}

void RunRecorder::row(recording::RunRow row)
{
    if (!isListening())
        return;
    m_batch.rows.push_back(std::move(row));
    m_batch.bytes += sizeof(recording::RunRow);
    if (m_batch.bytes > largestBatch)
        flush();
}

void RunRecorder::flush()
{
    if (m_batch.empty())
        return;
    auto batch = std::make_shared<recording::RunBatch>(std::exchange(m_batch, {}));
    batch->clocks = clocksNow();
    m_pending += batch->bytes;
    if (m_pending > m_options.mostPending) {
        m_pending -= batch->bytes;
        if (m_isRunning) {
            tell([ended = utcNow_us() / 1000](RunStore& store) { store.endRun(ended); });
            fail(QStringLiteral("the disk is too slow: record to another one"));
        }
        return; // the ring has a gap
    }
    tell([batch = std::shared_ptr<const recording::RunBatch>(std::move(batch))](RunStore& store) {
        store.append(batch);
    });
}

void RunRecorder::fail(const QString& reason)
{
    m_isRunning = false;
    m_shown.state = RecordingState::Failed;
    m_shown.reason = reason.toStdString();
    log(EventLevel::Error, QStringLiteral("The recording has stopped: %1").arg(reason));
}

void RunRecorder::log(EventLevel level, const QString& text)
{
    m_events.add(level, "Recording", text.toStdString(), monotonicNow());
    emit changed();
}

RecordingSnapshot RunRecorder::snapshot(Time now) const
{
    RecordingSnapshot snapshot = m_shown;
    if (m_isRunning)
        snapshot.elapsed_s = secondsFrom(now - m_started);
    snapshot.canKeep = m_hasRing;
    return snapshot;
}

} // namespace agv::session
