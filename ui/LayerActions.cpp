// SPDX-License-Identifier: Apache-2.0
#include "ui/LayerActions.h"

#include "ui/Workspace.h"

#include <algorithm>

namespace ui {

namespace {

/// "Sculpt 3": the first such name that is free.
QString nextLayerName(const core::Document& document)
{
    for (qsizetype number = qsizetype(document.layers.size()) + 1;; ++number) {
        const QString name = QObject::tr("Sculpt %1").arg(number);
        const bool taken = std::any_of(document.layers.begin(), document.layers.end(),
            [&name](const core::SculptLayer& layer) { return layer.name == name; });
        if (!taken)
            return name;
    }
}

} // namespace

core::Result<int> addLayer(Workspace& workspace)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return core::failure(core::ErrorCode::Internal, QStringLiteral("no study is open"));
    // While the engine is busy the new layer waits in line; its id is known all the same.
    const core::AddLayer edit{.name = nextLayerName(session->foreseenDocument())};
    if (const auto added = session->apply(edit); !added)
        return tl::unexpected(added.error());
    const int id = session->foreseenDocument().layers.back().id;
    workspace.setActiveLayer(id);
    return id;
}

} // namespace ui
