// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/edits/kinds/values/ThresholdSegment.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <optional>

namespace core {
class LabelReader;
}

namespace ui {

class Workspace;

/// Previews a threshold in all views before it becomes a step of the history. The preview is an
/// open edit of the session; for another interval it is rolled back and begun again. If requests
/// arrive faster than that, only the latest one is shown. Any other edit takes the preview back.
/// Once a preview has stayed for a moment, the segment's voxels in it are counted, beside the
/// window.
class ThresholdTrial : public QObject {
    Q_OBJECT

public:
    explicit ThresholdTrial(Workspace& workspace, QObject* parent = nullptr);

    /// Requests the preview of @p edit; it appears a moment later. Nothing is shown for an edit
    /// that the session refuses.
    void show(const core::ThresholdSegment& edit);
    /// Ends the preview; all voxels are as before.
    void drop();
    /// Carries @p edit out as a step. If it is the one that is previewed, the open edit is
    /// committed and nothing is computed again. The workspace tells the user the result or the
    /// reason of a refusal.
    void take(const core::ThresholdSegment& edit);
    /// How many voxels the segment has in the preview that is shown; none until they are counted.
    [[nodiscard]] std::optional<std::int64_t> voxels() const;
    /// Whether a preview is on its way, or its voxels are being counted.
    [[nodiscard]] bool isCounting() const;

Q_SIGNALS:
    void changed(); ///< voxels() or isCounting()

private:
    void begin();
    [[nodiscard]] bool isOpen() const;
    void count();
    void awaitBegin();
    void readOn();
    void stopCounting();

    Workspace& m_workspace;
    std::optional<core::ThresholdSegment> m_wanted;
    /// The edit that was begun; it may have been ended by another one since.
    std::optional<core::ThresholdSegment> m_shown;
    QTimer m_soon;
    QTimer m_countSoon; ///< delay after the preview has begun
    std::shared_ptr<core::LabelReader> m_reader; ///< null: nothing is being counted
    std::optional<std::int64_t> m_voxels; ///< of m_shown
    bool m_hasBegun = false; ///< the engine has begun m_shown; it may still be working on it
    core::Background m_counting; ///< last: it uses all of the above
};

} // namespace ui
