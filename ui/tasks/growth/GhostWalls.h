// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/coarse/CoarseFlood.h"
#include "core/history/History.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {
class LabelReader;
}

namespace ui {

class Workspace;

/// Reads for the ghost of a growth (GrowthGhost) where labels, sculpting and barriers close the
/// volume to it: labels and sculpting in portions, as questions between edits, and only those
/// bricks of barriers that hold some. Threads of its own put them into cells. What was read is kept
/// until an edit changes it. GUI thread.
class GhostWalls : public QObject {
    Q_OBJECT

public:
    struct Needs {
        std::uint8_t plane = 0; ///< the label plane of the growth
        bool labels = false;
        std::vector<std::uint8_t> layers{}; ///< sculpt layers that close what they carve
        core::RowId barriers = 0; ///< core::lastBarrierRow(); 0: they are not needed
        bool operator==(const Needs&) const = default;
    };
    /// By cell.
    using Cells = std::shared_ptr<const std::vector<std::uint8_t>>;
    struct Read {
        Cells labels; ///< null: not needed
        Cells coverage; ///< likewise
        std::shared_ptr<const core::CoarseBarriers> barriers; ///< likewise
        /// Refers to what is held here.
        [[nodiscard]] core::CoarseWalls walls() const;
    };

    explicit GhostWalls(Workspace& workspace, QObject* parent = nullptr);

    /// What is needed, as it is at the history's present position; none: it is being read, and
    /// read() or refused() is emitted when to ask again.
    /// @param grid always the same, until forget()
    /// @pre a session is open
    [[nodiscard]] std::optional<Read> of(const Needs& needs, const core::CoarseGrid& grid);
    /// Stops reading.
    void stop();
    /// To be called when another session is opened.
    void forget();

Q_SIGNALS:
    void read();
    void refused(); ///< something could not be read
    void lost(); ///< what of() has returned, or is about to, has changed

private:
    /// What the voxels of the cells hold in one plane, or the greatest that several layers hold.
    struct Planes {
        core::Field field = core::Field::Labels;
        std::vector<std::uint8_t> planes{};
        Cells cells{}; ///< null: not read
    };
    struct Barriers {
        std::uint8_t plane = 0;
        core::RowId row = 0; ///< core::lastBarrierRow() when they were read
        std::shared_ptr<const core::CoarseBarriers> cells; ///< null: they are being read
    };

    void lose(Planes& planes);
    void readPlanes(Planes& into, const std::vector<std::uint8_t>& planes);
    void readNextPlane();
    void readPlaneOn();
    void takePlane(const core::Result<Cells>& cells);
    void readBarriers(std::uint8_t plane, core::RowId row);
    void takeBarriers(const core::Result<std::vector<core::BrickImage>>& bricks);
    void refuse();
    void noteReading();

    Workspace& m_workspace;
    core::CoarseGrid m_grid;
    Planes m_labels{.field = core::Field::Labels};
    Planes m_coverage{.field = core::Field::Coverage};
    Planes* m_into = nullptr; ///< the planes that m_reader reads
    std::vector<std::uint8_t> m_left; ///< planes that it has still to read, the next one last
    std::shared_ptr<core::LabelReader> m_reader; ///< null: no plane is being read
    Cells m_greatest; ///< of those that were read; null: none yet

    std::optional<Barriers> m_barriers; ///< those that were read last
    std::shared_ptr<Barriers> m_looking; ///< null: no barriers are being read
    /// VoxelQuestions::beginReading(); null: neither of both is being read.
    std::shared_ptr<const void> m_reading;

    core::Background m_work; ///< last: it uses all of the above
};

} // namespace ui
