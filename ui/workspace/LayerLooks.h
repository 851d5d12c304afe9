// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QObject>

#include <map>
#include <vector>

namespace ui {

class Workspace;

/// How what a sculpt layer carves looks in the 3D view.
struct LayerLook {
    double hides = 1.0; ///< 0 … 1: how much of it is hidden; the rest shows through
    /// Volume rendering: so far into the cut matter fades out, 0 … 1 of what radiation reaches
    /// (three voxels).
    double softness = 0.0;
    bool operator==(const LayerLook&) const = default;
};

/// The looks of the document's sculpt layers. Display alone: no step of undo, since what is carved
/// counts as carved for every tool, however little of it is hidden; kept with the session.
///
/// Matter that a layer hides in part is drawn as a piece (gpu::ScenePiece) at home, translucent.
/// Part of Workspace.
class LayerLooks : public QObject {
    Q_OBJECT

public:
    explicit LayerLooks(Workspace& workspace);

    [[nodiscard]] const std::map<int, LayerLook>& looks() const { return m_looks; }
    [[nodiscard]] LayerLook look(int layer) const;
    void setLook(int layer, const LayerLook& look);
    /// Not of a layer that is a piece: the piece's own look says how that is drawn.
    [[nodiscard]] bool hasLook(int layer) const;

    [[nodiscard]] std::vector<gpu::ScenePiece> scene() const;

Q_SIGNALS:
    void changed();

private:
    Workspace& m_workspace;
    std::map<int, LayerLook> m_looks;
};

} // namespace ui
