// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QObject>

#include <map>
#include <vector>

namespace ui {

class Workspace;

/// How the matter that a sculpt layer carves looks in the 3D view.
struct LayerLook {
    double hides = 1.0; ///< 0 … 1: how much of it is hidden; the rest shows faintly
    /// Volume rendering: how far into the cut the matter fades out, 0 … 1 of the reach of radiation
    /// (three voxels).
    double softness = 0.0;
    bool operator==(const LayerLook&) const = default;
};

/// The looks of the document's sculpt layers. This is display state and not a step of undo: what is
/// carved counts as carved for every tool, however little of it is hidden. Kept with the session.
///
/// Matter that a layer hides in part is drawn as a translucent piece (gpu::ScenePiece) at its true
/// place. Part of Workspace.
class LayerLooks : public QObject {
    Q_OBJECT

public:
    explicit LayerLooks(Workspace& workspace);

    [[nodiscard]] const std::map<int, LayerLook>& looks() const { return m_looks; }
    [[nodiscard]] LayerLook look(int layer) const;
    void setLook(int layer, const LayerLook& look);
    /// Whether the layer has a look of its own. The layer of a piece has none: it is drawn by the
    /// look of the piece.
    [[nodiscard]] bool hasLook(int layer) const;

    [[nodiscard]] std::vector<gpu::ScenePiece> scene() const;

Q_SIGNALS:
    void changed();

private:
    Workspace& m_workspace;
    std::map<int, LayerLook> m_looks;
};

} // namespace ui
