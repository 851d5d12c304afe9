// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/Scene.h"

#include <QObject>

#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// The sketched seeds that no growth has taken up yet: those of the history's line up to its
/// position, after the last growth, of segments that are shown. Part of Workspace.
class PendingSeeds : public QObject {
    Q_OBJECT

public:
    explicit PendingSeeds(Workspace& workspace);

    [[nodiscard]] const std::vector<gpu::SceneSeed>& seeds() const { return *m_seeds; }
    /// The same for a picture of the 3D view.
    [[nodiscard]] std::shared_ptr<const std::vector<gpu::SceneSeed>> scene() const
    {
        return m_seeds;
    }

Q_SIGNALS:
    void changed();

private:
    void update();

    Workspace& m_workspace;
    std::shared_ptr<const std::vector<gpu::SceneSeed>> m_seeds;
};

} // namespace ui
