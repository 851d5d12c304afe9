// SPDX-License-Identifier: Apache-2.0
#pragma once

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

    /// By leaf.
    [[nodiscard]] const std::vector<std::uint32_t>& own() const { return m_own; }

Q_SIGNALS:
    void changed();

private:
    void askNext();
    void take(const std::vector<core::BrickImage>& bricks);
    [[nodiscard]] bool takeBrick(const core::BrickImage& brick);

    Workspace& m_workspace;
    std::shared_ptr<const ChunkLeaves> m_leaves;
    int m_segment = 0;
    std::uint8_t m_plane = 0;
    std::set<std::uint32_t> m_dirty; ///< bricks that are not asked about yet
    std::vector<bool> m_isOwn; ///< by voxel of the box
    std::vector<std::uint32_t> m_own;
    bool m_asking = false;
    int m_count = 0; ///< of begin(): only answers to the present one matter
};

} // namespace ui
