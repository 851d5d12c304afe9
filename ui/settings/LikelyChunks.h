// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/chunks/DoubtfulChunks.h"
#include "ui/settings/ChunkLeaves.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <vector>

namespace ui {

/// Searches a division for the few chunks that are most likely on the wrong side of a segment's
/// border (core::DoubtfulChunks), in the background. GUI thread.
class LikelyChunks : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t most = 3;

    explicit LikelyChunks(QObject* parent = nullptr);

    /// Starts a search. What was found before stays until its end, unless the number of chunks is
    /// another.
    /// @param segment label of the segment
    /// @param own number of the segment's voxels in each leaf
    /// @param count number of chunks of the division
    void look(const std::shared_ptr<const ChunkLeaves>& leaves, int segment,
        const std::vector<std::uint32_t>& own, int count);
    void forget();
    /// Whether a search is running, so that all() may still change.
    [[nodiscard]] bool isLooking() const { return m_background.busy(); }
    /// The chunks that were found, the most likely one first, each with its place in the box of the
    /// division.
    [[nodiscard]] const std::vector<core::DoubtfulChunks::Doubtful>& all() const { return m_all; }

Q_SIGNALS:
    void changed();

private:
    std::vector<core::DoubtfulChunks::Doubtful> m_all;
    int m_count = 0; ///< number of chunks for which they were found
    core::Background m_background; ///< last: it uses the above
};

} // namespace ui
