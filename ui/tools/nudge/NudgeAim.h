// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/base/Result.h"
#include "core/sculpt/labels/NudgeStart.h"

#include <QObject>

#include <functional>
#include <memory>

namespace core {
struct BrushPath;
}

namespace ui {

class Workspace;

/// Finds out where a nudge begins: on which side of the border of a segment, and how near it is
/// (core/sculpt/labels/NudgeStart.h). The engine reads the labels around the disc, another thread
/// looks at them, and the window waits for neither.
class NudgeAim : public QObject {
    Q_OBJECT

public:
    using Answer = std::function<void(const core::Result<core::NudgeStart>&)>;

    explicit NudgeAim(Workspace& workspace, QObject* parent = nullptr);

    /// As it is after everything that the session was asked to do before. What was asked here
    /// before is dropped. Errors: those of core::nudgeDisc(), and UnknownSegment; then nothing is
    /// asked.
    /// @param path of the disc, with its first point, rounded as edits are
    /// @param answer called later, when busy() is false again; not after drop(), nor when the
    /// session was closed meanwhile
    [[nodiscard]] core::Result<void> ask(const core::BrushPath& path, int segment, Answer answer);
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void look(const std::shared_ptr<Job>& job);
    void finish(const core::Result<core::NudgeStart>& start);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< what is under way; null: nothing
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
