// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/SessionDriver.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/engine/EditEngine.h"
#include "core/session/SessionStorage.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/session/state/RecentSteps.h"
#include "tests/support/scenes/CutEdits.h"
#include "ui/base/ErrorText.h"

#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <algorithm>
#include <chrono>
#include <utility>

#include <unistd.h>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

double SessionDriver::Commit::longestCallMs() const
{
    return *std::max_element(callsMs.begin(), callsMs.end());
}

std::unique_ptr<SessionDriver> SessionDriver::create(
    core::EditEngine& engine, const core::LoadedVolume& volume, const QString& file)
{
    std::unique_ptr<SessionDriver> driver(new SessionDriver(engine));
    auto session =
        core::EditSession::create(engine, volume, {.file = file, .wakeUp = [raw = driver.get()] {
                                                       const std::lock_guard lock(raw->m_guard);
                                                       raw->m_woken = true;
                                                       raw->m_changed.notify_all();
                                                   }});
    if (!session)
        return nullptr;
    driver->m_session = *std::move(session);
    return driver;
}

std::unique_ptr<SessionDriver> SessionDriver::open(
    core::EditEngine& engine, const core::LoadedVolume& volume, const QString& file)
{
    std::unique_ptr<SessionDriver> driver(new SessionDriver(engine));
    auto session = core::EditSession::open(engine, volume, file, [raw = driver.get()] {
        const std::lock_guard lock(raw->m_guard);
        raw->m_woken = true;
        raw->m_changed.notify_all();
    });
    if (!session)
        return nullptr;
    driver->m_session = *std::move(session);
    return driver;
}

void SessionDriver::note(const core::Result<void>& result)
{
    if (!result && m_problem.isEmpty())
        m_problem = ui::errorText(result.error());
}

template <typename Call> SessionDriver::Commit SessionDriver::timed(Call&& call)
{
    Commit commit;
    const Clock::time_point start = Clock::now();
    call();
    commit.callsMs.push_back(millisecondsSince(start));
    waitUntilIdle(commit);
    commit.wallMs = millisecondsSince(start);
    return commit;
}

void SessionDriver::waitUntilIdle(Commit& commit)
{
    while (!m_session->idle()) {
        {
            std::unique_lock lock(m_guard);
            m_changed.wait_for(lock, std::chrono::milliseconds(100),
                [this] { return std::exchange(m_woken, false); });
        }
        const Clock::time_point start = Clock::now();
        m_session->poll();
        commit.callsMs.push_back(millisecondsSince(start));
    }
}

SessionDriver::Commit SessionDriver::apply(const core::Edit& edit)
{
    return timed([&] { note(m_session->apply(edit)); });
}

SessionDriver::Commit SessionDriver::stroke(const core::Edit& stroke)
{
    note(m_session->begin(test::begunStroke(stroke)));
    for (const core::PenSample& sample : *core::penSamplesOf(stroke)) {
        m_session->extend(core::PenSamples{.samples = {sample}});
        m_session->poll();
    }
    // The pen is slower than this loop: by pen-up the cut is done.
    m_engine.finish();
    m_session->poll();
    Commit commit = timed([this] { m_session->end(core::Ending::Commit); });
    note(m_session->settle());
    return commit;
}

SessionDriver::Commit SessionDriver::undo()
{
    return timed([this] { note(m_session->undo()); });
}

SessionDriver::Commit SessionDriver::redo()
{
    return timed([this] { note(m_session->redo()); });
}

SessionDriver::Commit SessionDriver::goTo(core::RowId row)
{
    return timed([this, row] { note(m_session->goTo(row)); });
}

void SessionDriver::keepSteps(bool kept)
{
    m_session->storage().setStepMemory(kept ? core::RecentSteps::usualBytes : 0);
}

void SessionDriver::settle()
{
    note(m_session->settle());
}

QByteArray SessionDriver::hash()
{
    settle();
    return m_session->stateHash();
}

std::vector<std::uint8_t> SessionDriver::dense(core::Field field, std::uint8_t plane)
{
    constexpr int side = core::BrickGrid::side;
    constexpr std::uint32_t bricksAtOnce = 4096;
    note(m_session->settle());
    const glm::ivec3 size = m_session->document().volumes.front().geometry.size;
    const core::BrickGrid grid{size};
    const auto count = std::uint32_t(grid.brickCount());
    std::vector<std::uint8_t> voxels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    for (std::uint32_t first = 0; first < count; first += bricksAtOnce) {
        std::vector<core::BrickKey> keys;
        for (std::uint32_t brick = first; brick < std::min(first + bricksAtOnce, count); ++brick)
            keys.push_back({field, plane, brick});
        const auto take = [&](const core::Result<std::vector<core::BrickImage>>& bricks) {
            for (const core::BrickImage& brick : *bricks) {
                if (brick.bytes.empty())
                    continue;
                const core::VoxelBox box = grid.boxOf(int(brick.key.brick));
                for (int z = box.minimum.z; z < box.maximum.z; ++z) {
                    for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                        const std::size_t from = std::size_t(((z % side) * side + y % side) * side);
                        const std::size_t to = std::size_t(box.minimum.x)
                            + std::size_t(size.x)
                                * (std::size_t(y) + std::size_t(size.y) * std::size_t(z));
                        std::copy_n(brick.bytes.read().begin() + std::ptrdiff_t(from),
                            box.maximum.x - box.minimum.x, voxels.begin() + std::ptrdiff_t(to));
                    }
                }
            }
        };
        m_session->questions().bricks(std::move(keys), take);
        note(m_session->settle());
    }
    return voxels;
}

qint64 bytesInFile(const QString& file, core::RowId row)
{
    qint64 bytes = 0;
    {
        QSqlDatabase database =
            QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("bench"));
        database.setDatabaseName(file);
        if (database.open()) {
            QSqlQuery query(database);
            query.prepare(QStringLiteral(
                "SELECT LENGTH(name) + LENGTH(edit) + LENGTH(statistics) + LENGTH(chain)"
                " + LENGTH(stateHash) + LENGTH(deltaSha256) + LENGTH(seal)"
                " + (SELECT SUM(LENGTH(bytes)) FROM delta WHERE delta.row = row.id)"
                " FROM row WHERE id = ?"));
            query.addBindValue(qint64(row));
            if (query.exec() && query.next())
                bytes = query.value(0).toLongLong();
        }
    }
    QSqlDatabase::removeDatabase(QStringLiteral("bench"));
    return bytes;
}

qint64 residentBytes()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toLongLong() * sysconf(_SC_PAGESIZE);
}

} // namespace bench
