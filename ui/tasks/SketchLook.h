// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/growth/SketchInterval.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// Finds out which values were sketched (core/growth/SketchInterval.h). The voxels are read by the
/// engine and looked at on another thread, so that the window does not wait.
class SketchLook : public QObject {
    Q_OBJECT

public:
    explicit SketchLook(Workspace& workspace, QObject* parent = nullptr);

    /// Drops the question before.
    void ask(std::vector<core::SeedSketch> sketches);
    /// Drops the question; to be called when the session is another one.
    void drop();

Q_SIGNALS:
    /// The answer to the last question, unless it was dropped.
    /// @param seeds codes of all sketched voxels, in their order
    void found(const core::SketchedCodes& sketched, const std::vector<int>& seeds);

private:
    struct Question;
    void read(std::shared_ptr<const Question> question);
    void look(std::shared_ptr<const Question> question, std::vector<int> codes);

    Workspace& m_workspace;
    std::uint64_t m_asked = 0; ///< number of questions; only the answer to the last one counts
    core::Background m_background;
};

} // namespace ui
