// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/refine/mesh/SurfaceMirror.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>

#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// Finds parts of the surface that is being refined which may need a second look (seed B §4.3;
/// core/refine/fit/DoubtfulVertices.h). The search runs on another thread; its results are
/// reported, never applied. GUI thread.
class SurfaceDoubts : public QObject {
    Q_OBJECT

public:
    struct Doubt {
        enum class Why {
            NoEdge, ///< the surface follows the mask where grey values show no edge
            OffMask, ///< a part marked green or red is away from the present segment
        };
        Why why = Why::NoEdge;
        core::MarkedRegion region; ///< where views show it
    };

    explicit SurfaceDoubts(Workspace& workspace, QObject* parent = nullptr);

    /// Starts the search; earlier results are dropped.
    void look();
    [[nodiscard]] bool isLooking() const { return m_job != nullptr; }
    /// The results, of each kind the largest first, for the surface as it was when the search
    /// began.
    [[nodiscard]] const std::vector<Doubt>& doubts() const { return m_doubts; }
    /// Whether these are the results of a search: without one, none means nothing.
    [[nodiscard]] bool hasFound() const { return m_hasFound; }

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    struct Job;
    void forget();
    void askForCodes(const std::shared_ptr<Job>& job);
    void workOut(const std::shared_ptr<Job>& job);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    LabelFetch m_fetch;
    std::shared_ptr<Job> m_job; ///< what is under way
    std::vector<Doubt> m_doubts;
    bool m_hasFound = false;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
