// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/brick/BrickGrid.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/settings/ChunkLeaves.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

namespace ui {

class Workspace;

/// Counts how many voxels of each chunk of the finest division belong to a segment. It asks the
/// engine for the bricks that have changed, some at a time.
class ChunkMembers : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t usualBricks = 1024; ///< 4 MiB

    /// @param bricksAtOnce how many bricks are requested from the engine at once; other work can
    ///     run between requests
    explicit ChunkMembers(
        Workspace& workspace, QObject* parent = nullptr, std::size_t bricksAtOnce = usualBricks);

    /// Starts counting.
    /// @param leaves null: nothing is counted
    void begin(std::shared_ptr<const ChunkLeaves> leaves, int segment);
    /// Labels have changed in this box: counts there again.
    void look(const core::VoxelBox& box);

    /// Whether counting is under way, so that own() may still change.
    [[nodiscard]] bool isCounting() const { return m_asking; }
    /// The number of the segment's voxels, by leaf.
    [[nodiscard]] const std::vector<std::uint32_t>& own() const { return m_own; }

Q_SIGNALS:
    void changed();
    void counted(); ///< own() is complete, for now

private:
    void askNext();
    void take(std::vector<core::BrickImage> bricks);

    /// The state of counting; used on the worker's thread.
    struct Voxels {
        std::shared_ptr<const ChunkLeaves> leaves;
        int segment = 0;
        std::vector<bool> isOwn; ///< by voxel of the box
        std::vector<std::uint32_t> own; ///< by leaf

        void take(const core::BrickImage& brick);
    };

    Workspace& m_workspace;
    std::size_t m_bricksAtOnce;
    std::shared_ptr<const ChunkLeaves> m_leaves;
    std::uint8_t m_plane = 0;
    std::set<std::uint32_t> m_dirty; ///< bricks that were not requested yet
    std::vector<std::uint32_t> m_own;
    bool m_asking = false;
    int m_count = 0; ///< number of the latest begin(); answers to earlier ones are dropped
    std::shared_ptr<Voxels> m_voxels;
    core::Background m_counting; ///< last: its results are delivered to all of the above
};

} // namespace ui
