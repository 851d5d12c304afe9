// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Says what a targeted shrink would remove while the pen is down (VoxelQuestions::previewCut()).
/// The engine tints the voxels; this class asks it, one question at a time, and puts the answer
/// into words. Nothing waits and nothing changes.
class ShrinkPreview : public QObject {
    Q_OBJECT

public:
    explicit ShrinkPreview(Workspace& workspace, QObject* parent = nullptr);

    /// @param onlyHere whether only the sketched voxels are to be removed
    void begin(bool onlyHere);
    /// Sets all voxels that are sketched so far.
    void follow(const std::vector<glm::ivec3>& voxels);
    /// Ends the preview and removes the tint.
    void end();

    /// "takes 12.4 mL", or why it will remove nothing; empty while there is no sketch.
    [[nodiscard]] QString words() const;
    /// The number of voxels in the latest answer; none if there was none yet.
    [[nodiscard]] std::optional<std::int64_t> voxels() const;
    /// Whether the latest answer covers everything that is sketched.
    [[nodiscard]] bool upToDate() const { return m_cutPreview && m_answered == m_wanted.size(); }

Q_SIGNALS:
    void changed();

private:
    void ask();
    /// @param cutPreview none if it is still being computed
    void take(const core::Result<std::optional<core::CutPreview>>& cutPreview);

    Workspace& m_workspace;
    bool m_on = false;
    bool m_onlyHere = false;
    bool m_asking = false;
    std::vector<glm::ivec3> m_wanted;
    std::size_t m_asked = 0; ///< number of voxels in the question under way
    std::size_t m_answered = 0; ///< number of voxels in the question that was answered last
    std::optional<core::CutPreview> m_cutPreview; ///< without its bricks
    std::optional<core::Error> m_refused; ///< why the last question found nothing to remove
    QTimer m_again; ///< asks again while the answer is being computed
    int m_sketch = 0; ///< number of the present sketch
};

} // namespace ui
