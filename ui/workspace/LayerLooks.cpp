// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/LayerLooks.h"

#include "ui/workspace/Workspace.h"

namespace ui {

LayerLooks::LayerLooks(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_looks.clear();
        Q_EMIT changed();
    });
}

LayerLook LayerLooks::look(int layer) const
{
    const auto found = m_looks.find(layer);
    return found == m_looks.end() ? LayerLook() : found->second;
}

void LayerLooks::setLook(int layer, const LayerLook& look)
{
    if (look == this->look(layer))
        return;
    m_looks[layer] = look;
    Q_EMIT changed();
}

bool LayerLooks::hasLook(int layer) const
{
    const core::EditSession* session = m_workspace.session();
    return session && session->document().layer(layer) && !session->document().pieceOfLayer(layer);
}

std::vector<gpu::ScenePiece> LayerLooks::scene() const
{
    std::vector<gpu::ScenePiece> result;
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return result;
    for (const core::SculptLayer& layer : session->document().layers) {
        const LayerLook look = this->look(layer.id);
        if (look == LayerLook() || !session->document().carves(layer) || !hasLook(layer.id))
            continue;
        gpu::ScenePiece drawn;
        drawn.layer = layer.id;
        drawn.opacity = float(1.0 - look.hides);
        drawn.softness = float(look.softness);
        result.push_back(drawn);
    }
    return result;
}

} // namespace ui
