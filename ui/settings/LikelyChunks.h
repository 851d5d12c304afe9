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

/// The few chunks of a division that the user will most likely click on (core::DoubtfulChunks),
/// looked for beside the window.
class LikelyChunks : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t most = 3;

    explicit LikelyChunks(QObject* parent = nullptr);

    /// Looks for them; those found before stay until then, unless the number of chunks is another.
    /// @param own the number of the segment's voxels, by leaf
    void look(const std::shared_ptr<const ChunkLeaves>& leaves, int segment,
        const std::vector<std::uint32_t>& own, int count);
    void forget();
    /// Whether they are being looked for, so that all() may still change.
    [[nodiscard]] bool isLooking() const { return m_background.busy(); }
    /// The most likely one first; each with its place in the box.
    [[nodiscard]] const std::vector<core::DoubtfulChunks::Doubtful>& all() const { return m_all; }

Q_SIGNALS:
    void changed();

private:
    std::vector<core::DoubtfulChunks::Doubtful> m_all;
    int m_count = 0; ///< for which they are
    core::Background m_background; ///< last: it uses the above
};

} // namespace ui
