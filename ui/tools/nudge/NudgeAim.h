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

/// Finds out how a nudge begins: on which side of a segment's border, and how far from it
/// (core/sculpt/labels/NudgeStart.h). The engine reads the labels around the disc and a background
/// thread evaluates them, so the window does not wait. GUI thread.
class NudgeAim : public QObject {
    Q_OBJECT

public:
    using Answer = std::function<void(const core::Result<core::NudgeStart>&)>;

    explicit NudgeAim(Workspace& workspace, QObject* parent = nullptr);

    /// Asks for the state after all edits that were given to the session before. An earlier
    /// question is dropped. Errors: those of core::nudgeDisc(), and UnknownSegment; then nothing is
    /// asked.
    /// @param path of the disc, with its first point, quantised as edits are
    /// @param segment label
    /// @param answer is called later, when busy() is false again; not after drop() or when the
    /// session was closed meanwhile
    [[nodiscard]] core::Result<void> ask(const core::BrushPath& path, int segment, Answer answer);
    /// Drops the question; its answer is not called.
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void look(const std::shared_ptr<Job>& job);
    void finish(const core::Result<core::NudgeStart>& start);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< null: no question is open
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
