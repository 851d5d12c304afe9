// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/base/Result.h"
#include "core/growth/ProbedVoxel.h"
#include "core/growth/coarse/CoarseFlood.h"
#include "ui/tasks/growth/GhostWalls.h"
#include "ui/workspace/PendingSeeds.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Shows in all views, before a growth begins, approximately what it would take for the active
/// segment: the region connected with its waiting seeds within the interval (core::coarseFlood()),
/// as a translucent body. The volume is divided into at most two million cells, whose codes are
/// read once for each session, a slice at a time. The region is limited by other segments,
/// barriers, carved tissue, the editable range and the box of the growth (GhostWalls), by segments
/// whose seeds grow together with it, by the means around strokes, and by a passage width of at
/// least two cells; the other criteria are ignored. Everything is computed on threads of its own,
/// and no edit or picture waits for it. If settings arrive faster than it can follow, only the
/// latest ones are used. GUI thread.
class GrowthGhost : public QObject {
    Q_OBJECT

public:
    static constexpr std::int64_t usualCells = 1 << 21;

    /// @param mostCells into how many cells a volume is divided at most
    explicit GrowthGhost(
        Workspace& workspace, QObject* parent = nullptr, std::int64_t mostCells = usualCells);

    /// Reads the codes of the open session, so that the first ghost comes at once. Does nothing if
    /// they were read already. If that has failed, it is tried again only after another tool was
    /// chosen.
    void prepare();
    /// Shows the ghost of the present seeds and settings. To be called when any of these may have
    /// changed; costs nothing if none has. There is none without waiting seeds, or while an edit
    /// stands open.
    /// @param wanted false: no ghost
    /// @param settled false: the interval is about to follow the seeds; the ghost of the active
    /// segment stays as it is until then
    void follow(bool wanted, bool settled = true);

    /// About how many voxels the ghost that is shown has; none: there is no ghost.
    [[nodiscard]] std::optional<std::int64_t> voxels() const { return m_voxels; }
    /// Whether what is shown is what follow() asked for last.
    [[nodiscard]] bool upToDate() const { return m_wanted == m_shown; }
    /// "about 12.4 mL", and which criterion was left out; empty without a ghost.
    [[nodiscard]] QString words() const;

Q_SIGNALS:
    void changed(); ///< voxels()

private:
    /// The seeds whose means are requested.
    struct Means {
        core::RowId position = 0; ///< of the history, which knows the strokes
        std::uint8_t plane = 0;
        core::CodeInterval interval;
        int sigmas256 = 0;
        bool operator==(const Means&) const = default;
    };
    /// What a ghost is of.
    struct Wanted {
        int label = 0;
        std::uint8_t plane = 0;
        std::uint32_t rgb = 0;
        std::shared_ptr<const std::vector<gpu::SceneSeed>> seeds;
        core::CoarseRule rule;
        std::bitset<256> rivals; ///< labels that grow together with it
        GhostWalls::Needs walls;
        std::optional<Means> means; ///< none: its codes need not be like those around seeds
        bool operator==(const Wanted&) const = default;
    };
    struct Drawn {
        PendingSeeds::Ghost ghost;
        std::int64_t voxels = 0;
        bool tellsWidth = false; ///< whether the passage width is taken into account
    };
    [[nodiscard]] std::optional<Wanted> present() const;
    void forget();
    void drop();
    void advance();
    void readSlice();
    void takeSlice(int layer, std::vector<std::uint16_t> slice);
    void refuse();
    void readSeeds();
    void readMeans();
    void loseWalls();
    void flood(const GhostWalls::Read& read);
    void take(const Wanted& of, const core::Result<Drawn>& drawn);

    Workspace& m_workspace;
    std::int64_t m_mostCells;
    std::optional<Wanted> m_wanted;
    std::optional<Wanted> m_shown;
    std::optional<std::int64_t> m_voxels;
    bool m_isFlooding = false;
    bool m_tellsWidth = false; ///< what is shown takes the passage width into account
    QTimer m_soon; ///< delay of a ghost where there is none: the interval may follow the seeds

    std::shared_ptr<core::CoarseCodes> m_reading; ///< being filled by m_reads; null: not reading
    int m_nextLayer = 0; ///< of those to ask for
    int m_layersTaken = 0;
    bool m_isRefused = false; ///< codes could not be read since the tool was taken
    std::shared_ptr<const core::CoarseCodes> m_codes; ///< null: not read yet

    /// The seeds that were asked about last, those of all segments; null: none.
    std::shared_ptr<const std::vector<gpu::SceneSeed>> m_askedSeeds;
    std::optional<std::vector<core::CoarseSeed>> m_seeds; ///< these with their codes

    std::optional<Means> m_askedMeans; ///< none: none are being asked for
    std::optional<Means> m_meansOf; ///< what m_means were asked for; none: no means
    std::vector<core::ProbedSeeds> m_means;

    GhostWalls m_walls;

    core::Background m_floods; ///< these last: they use all of the above
    core::Background m_reads;
};

} // namespace ui
