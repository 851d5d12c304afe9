// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GhostWalls.h"

#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

/// The greater of both at each cell. Empty: all 0.
std::vector<std::uint8_t> greatestOf(
    std::vector<std::uint8_t> one, const std::vector<std::uint8_t>& other)
{
    if (one.empty())
        return other;
    for (std::size_t i = 0; i < other.size(); ++i)
        one[i] = std::max(one[i], other[i]);
    return one;
}

} // namespace

core::CoarseWalls GhostWalls::Read::walls() const
{
    core::CoarseWalls walls{.barriers = barriers.get()};
    if (labels)
        walls.labels = *labels;
    if (coverage)
        walls.coverage = *coverage;
    return walls;
}

GhostWalls::GhostWalls(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    using What = core::DocumentChange::What;
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == What::Labels)
                return lose(m_labels);
            if (change.what == What::Coverage)
                return lose(m_coverage);
            // Those that are being read may be of either side of it.
            if (change.what != What::Growth || change.box.empty()
                || !std::exchange(m_looking, nullptr))
                return;
            noteReading();
            Q_EMIT lost();
        });
}

void GhostWalls::lose(Planes& planes)
{
    const bool isRead = m_reader && m_into == &planes;
    if (!planes.cells && !isRead)
        return;
    planes.cells.reset();
    if (isRead)
        m_reader.reset();
    noteReading();
    Q_EMIT lost();
}

void GhostWalls::stop()
{
    m_reader.reset();
    m_looking.reset();
    noteReading();
}

/// What is previewed in passing would be read along, so it waits.
void GhostWalls::noteReading()
{
    if (!m_reader && !m_looking)
        m_reading.reset();
    else if (!m_reading)
        m_reading = m_workspace.session()->questions().beginReading();
}

void GhostWalls::forget()
{
    stop();
    m_work.cancel();
    m_labels.cells.reset();
    m_coverage.cells.reset();
    m_barriers.reset();
}

/// Silently: a picture or an edit will say why.
void GhostWalls::refuse()
{
    stop();
    Q_EMIT refused();
}

std::optional<GhostWalls::Read> GhostWalls::of(const Needs& needs, const core::CoarseGrid& grid)
{
    m_grid = grid;
    Read read;
    const auto take = [&](Planes& from, const std::vector<std::uint8_t>& planes, Cells& into) {
        if (!from.cells || from.planes != planes) {
            readPlanes(from, planes);
            return false;
        }
        into = from.cells;
        return true;
    };
    if (needs.labels && !take(m_labels, {needs.plane}, read.labels))
        return std::nullopt;
    if (!needs.layers.empty() && !take(m_coverage, needs.layers, read.coverage))
        return std::nullopt;
    if (needs.barriers != 0) {
        // Bricks are read as they are now, also for who asks for barriers that were drawn over.
        const core::RowId row =
            m_workspace.seeds().past().of(*m_workspace.session(), needs.plane).barriers;
        if (!m_barriers || m_barriers->plane != needs.plane || m_barriers->row != row) {
            readBarriers(needs.plane, row);
            return std::nullopt;
        }
        read.barriers = m_barriers->cells;
    }
    return read;
}

void GhostWalls::readPlanes(Planes& into, const std::vector<std::uint8_t>& planes)
{
    if (m_reader && m_into == &into && into.planes == planes)
        return;
    into.cells.reset();
    into.planes = planes;
    m_into = &into;
    m_left = planes;
    m_greatest.reset();
    readNextPlane();
}

void GhostWalls::readNextPlane()
{
    m_reader = std::make_shared<core::LabelReader>(m_grid.volumeSize, m_left.back(), m_into->field);
    m_left.pop_back();
    noteReading();
    readPlaneOn();
}

void GhostWalls::readPlaneOn()
{
    const auto take = [walls = QPointer<GhostWalls>(this), reader = m_reader](
                          const core::Result<void>& portion) {
        if (!walls || walls->m_reader != reader)
            return; // nobody waits for them any more, or they have changed
        if (portion)
            walls->readPlaneOn();
        else
            walls->refuse();
    };
    if (m_workspace.session()->questions().readOn(m_reader, take))
        return;
    m_work.start(
        this,
        [reader = m_reader, grid = m_grid, greatest = m_greatest]() -> Cells {
            std::vector<std::uint8_t> cells = reader->sampled(grid);
            return std::make_shared<const std::vector<std::uint8_t>>(
                greatest ? greatestOf(std::move(cells), *greatest) : std::move(cells));
        },
        [this, reader = m_reader](const core::Result<Cells>& cells) {
            if (m_reader == reader)
                takePlane(cells);
        });
}

void GhostWalls::takePlane(const core::Result<Cells>& cells)
{
    if (!cells) // memory has run out
        return refuse();
    m_reader.reset();
    m_greatest = *cells;
    if (!m_left.empty())
        return readNextPlane();
    noteReading();
    m_into->cells = std::exchange(m_greatest, nullptr);
    Q_EMIT read();
}

void GhostWalls::readBarriers(std::uint8_t plane, core::RowId row)
{
    if (m_looking && m_looking->plane == plane && m_looking->row == row)
        return;
    m_looking = std::make_shared<Barriers>(Barriers{.plane = plane, .row = row, .cells = {}});
    noteReading();
    m_workspace.session()->questions().barriers(plane,
        [walls = QPointer<GhostWalls>(this), looking = m_looking](
            const core::Result<std::vector<core::BrickImage>>& bricks) {
            if (walls && walls->m_looking == looking)
                walls->takeBarriers(bricks);
        });
}

void GhostWalls::takeBarriers(const core::Result<std::vector<core::BrickImage>>& bricks)
{
    if (!bricks)
        return refuse();
    m_work.start(
        this,
        [looking = m_looking, bricks = *bricks, grid = m_grid] {
            looking->cells =
                std::make_shared<const core::CoarseBarriers>(grid, core::barriersIn(bricks));
        },
        [this, looking = m_looking](const core::Result<void>& taken) {
            if (m_looking != looking)
                return;
            if (!taken) // memory has run out
                return refuse();
            m_looking.reset();
            noteReading();
            m_barriers = *looking;
            Q_EMIT read();
        });
}

} // namespace ui
