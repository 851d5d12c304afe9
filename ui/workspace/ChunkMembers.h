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

/// How many voxels of each chunk of the finest division a segment has now. The engine is asked for
/// the bricks that changed, some at a time.
class ChunkMembers : public QObject {
    Q_OBJECT

public:
    explicit ChunkMembers(Workspace& workspace, QObject* parent = nullptr);

    /// Counts anew. @param leaves null: nothing is counted
    void begin(std::shared_ptr<const ChunkLeaves> leaves, int segment);
    /// Labels changed there.
    void look(const core::VoxelBox& box);

    /// What own() says is still to change.
    [[nodiscard]] bool isCounting() const { return m_asking; }
    /// By leaf.
    [[nodiscard]] const std::vector<std::uint32_t>& own() const { return m_own; }

Q_SIGNALS:
    void changed();

private:
    void askNext();
    void take(std::vector<core::BrickImage> bricks);

    /// What is counted, beside the window: of the worker's thread while it counts.
    struct Voxels {
        std::shared_ptr<const ChunkLeaves> leaves;
        int segment = 0;
        std::vector<bool> isOwn; ///< by voxel of the box
        std::vector<std::uint32_t> own; ///< by leaf

        void take(const core::BrickImage& brick);
    };

    Workspace& m_workspace;
    std::shared_ptr<const ChunkLeaves> m_leaves;
    std::uint8_t m_plane = 0;
    std::set<std::uint32_t> m_dirty; ///< bricks that are not asked about yet
    std::vector<std::uint32_t> m_own;
    bool m_asking = false;
    int m_count = 0; ///< of begin(): only answers to the present one matter
    std::shared_ptr<Voxels> m_voxels;
    core::Background m_counting; ///< last: what it tells comes back to all of the above
};

} // namespace ui
