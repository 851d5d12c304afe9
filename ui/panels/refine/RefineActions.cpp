// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/RefineActions.h"

#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "ui/base/Actions.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

namespace ui {

QStringList addRefineActions(Actions& actions, Workspace& workspace)
{
    Refinement& refinement = workspace.refinement();
    const auto hasSurface = [&refinement] { return refinement.surface().has_value(); };
    const auto add = [&](const char* id, const QString& text, const QList<QKeySequence>& keys,
                         std::function<void()> run, std::function<bool()> possible) {
        actions.add({.id = QLatin1String(id),
            .text = text,
            .keys = keys,
            .run = std::move(run),
            .possible = std::move(possible)});
        return QString(QLatin1String(id));
    };
    const auto marks = [&](const char* id, const QString& text, core::ChangeMarks::Way way) {
        return add(
            id, text, {}, [&refinement, way] { refinement.changeMarks({.way = way}); }, hasSurface);
    };
    using Way = core::ChangeMarks::Way;
    return {add(
                "refine.lay", Actions::tr("Lay surface around segment"), {},
                [&refinement] { refinement.lay(core::LaySurface().vertices); },
                [&workspace] { return workspace.session() && workspace.activeSegment() != 0; }),
        add(
            "refine.writeBack", Actions::tr("Write surface back"),
            {QKeySequence(QStringLiteral("Ctrl+Return"))},
            [&refinement] { refinement.writeBack(); },
            [&refinement] {
                const auto surface = refinement.surface();
                return surface && surface->isApart();
            }),
        add(
            "refine.follow", Actions::tr("Follow mask"), {},
            [&refinement] { refinement.followMask(); }, hasSurface),
        add(
            "refine.barrier", Actions::tr("Make surface a barrier"), {},
            [&refinement] { refinement.makeBarrier(false); }, hasSurface),
        add(
            "refine.openBarrier", Actions::tr("Open barrier around surface"), {},
            [&refinement] { refinement.makeBarrier(true); }, hasSurface),
        add(
            "refine.layCrossings", Actions::tr("Lay crossing parts anew"), {},
            [&refinement] { refinement.layCrossings(); }, hasSurface),
        add(
            "refine.drop", Actions::tr("Remove surface"), {}, [&refinement] { refinement.drop(); },
            hasSurface),
        QString(), marks("refine.growMarks", Actions::tr("Grow marks"), Way::Grow),
        marks("refine.shrinkMarks", Actions::tr("Shrink marks"), Way::Shrink),
        marks("refine.invertMarks", Actions::tr("Invert marks"), Way::Invert),
        marks("refine.clearMarks", Actions::tr("Clear marks"), Way::Clear), QString(),
        add(
            "refine.nextError", Actions::tr("Next place to check"),
            {QKeySequence(QStringLiteral("N"))}, [&refinement] { refinement.goToError(1); },
            hasSurface),
        add(
            "refine.previousError", Actions::tr("Previous place to check"),
            {QKeySequence(QStringLiteral("Shift+N"))}, [&refinement] { refinement.goToError(-1); },
            hasSurface)};
}

} // namespace ui
