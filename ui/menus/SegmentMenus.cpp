// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentMenus.h"

#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/session/EditSession.h"
#include "ui/base/MenuText.h"
#include "ui/measure/DistanceOfSegments.h"
#include "ui/menus/EditableButton.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QMenu>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace ui {

namespace {

/// One of them, as it is when the menu opens.
struct Combination {
    QMenu* menu = nullptr;
    QString text;
    QString named; ///< with the segment's name
    std::function<void(int label, int other)> run{};
    OtherSegment kind = OtherSegment::Changed;
    std::function<void(int label, int other)> pointedAt{}; ///< other 0: nothing can be done

    void list(Workspace& workspace, int label, bool isNamed) const
    {
        const core::EditSession* session = workspace.session();
        const core::Segment* segment = session ? session->document().segment(label) : nullptr;
        menu->clear();
        menu->setTitle(isNamed && segment ? named.arg(menuText(segment->name)) : text);
        const bool changes = kind != OtherSegment::Any;
        QString why = changes || !segment ? whyUnchangeable(segment) : QString();
        if (why.isEmpty())
            why = listOtherSegments(
                *menu, session->document(), label,
                [&workspace, session, label, combine = run](int other) {
                    if (workspace.session() == session)
                        combine(label, other);
                },
                kind,
                [label, pointed = pointedAt](int other) {
                    if (pointed)
                        pointed(label, other);
                });
        if (kind == OtherSegment::Overlapping)
            menu->menuAction()->setVisible(session && session->document().labelPlanes().size() > 1);
        // Where one is locked, the list shows which.
        menu->menuAction()->setEnabled(!menu->isEmpty());
        menu->menuAction()->setToolTip(why);
    }
};

/// "'Liver', 'Kidney' and 3 more"
QString namesIn(const core::Document& document, std::uint8_t plane)
{
    constexpr qsizetype most = 3;
    QStringList names;
    for (const core::Segment& segment : document.segments) {
        if (segment.plane == plane)
            names += QStringLiteral("'%1'").arg(menuText(segment.name));
    }
    const qsizetype more = names.size() - most;
    const QString listed = names.mid(0, most).join(QStringLiteral(", "));
    return more > 0 ? QObject::tr("%1 and %2 more").arg(listed, QString::number(more)) : listed;
}

void listOverlaps(QMenu& menu, Workspace& workspace)
{
    menu.clear();
    core::EditSession* session = workspace.session();
    menu.menuAction()->setEnabled(session != nullptr);
    if (!session)
        return;
    const auto list = [&](const QString& text, std::uint8_t plane) {
        return menu.addAction(text, &menu, [&workspace, session, plane] {
            if (workspace.session() != session)
                return;
            if (const auto added = addSegment(workspace, plane); !added)
                workspace.fail(added.error());
        });
    };
    const core::Document& document = session->document();
    const std::optional<std::uint8_t> empty = document.planeWithoutSegments();
    QAction* all = list(QObject::tr("All others"), empty.value_or(0));
    all->setEnabled(empty.has_value());
    all->setToolTip(empty ? QString()
                          : QObject::tr("segments lie in each of the %1 label planes")
                                .arg(core::mostLabelPlanes));
    std::vector<std::uint8_t> planes = document.labelPlanes();
    std::erase_if(planes, [&](std::uint8_t plane) { return document.labelsIn(plane).none(); });
    for (std::size_t i = 0; planes.size() > 1 && i < planes.size(); ++i)
        list(QObject::tr("All but %1").arg(namesIn(document, planes[i])), planes[i]);
}

} // namespace

QString whyUnchangeable(const core::Segment* segment)
{
    if (!segment)
        return QObject::tr("there is no segment");
    return segment->locked ? QObject::tr("'%1' is locked").arg(segment->name) : QString();
}

QString listOtherSegments(QMenu& menu, const core::Document& document, int but,
    const std::function<void(int)>& choose, OtherSegment kind,
    const std::function<void(int)>& pointedAt)
{
    menu.setToolTipsVisible(true);
    QString why = QObject::tr("there is no other segment");
    const core::Segment* own = document.segment(but);
    bool possible = false;
    bool apart = false;
    for (const core::Segment& each : document.segments) {
        if (each.label == but)
            continue;
        QAction* entry = menu.addAction(menuText(each.name));
        QObject::connect(entry, &QAction::triggered, &menu,
            [choose, label = int(each.label)] { choose(label); });
        const bool changes = kind == OtherSegment::Changed || kind == OtherSegment::Unlocked;
        QString whyNot = changes ? whyUnchangeable(&each) : QString();
        const bool isBeside = own && each.plane == own->plane;
        if (kind == OtherSegment::Changed && !isBeside) {
            whyNot = QObject::tr("'%1' lies on another label plane").arg(each.name);
            apart = true;
        }
        if (kind == OtherSegment::Overlapping && isBeside)
            whyNot = QObject::tr("'%1' lies on the same label plane: no voxel belongs to both")
                         .arg(each.name);
        entry->setEnabled(whyNot.isEmpty());
        entry->setToolTip(whyNot);
        if (pointedAt)
            QObject::connect(entry, &QAction::hovered, &menu,
                [pointedAt, label = whyNot.isEmpty() ? int(each.label) : 0] { pointedAt(label); });
        possible = possible || whyNot.isEmpty();
        why = kind == OtherSegment::Overlapping
            ? QObject::tr("every other segment lies on the same label plane")
            : apart ? QObject::tr("every other segment is locked or lies on another label plane")
                    : QObject::tr("every other segment is locked");
    }
    return possible ? QString() : why;
}

QMenu& menuOf(QMenu& menu, const SegmentAction& action)
{
    if (action.submenu.isEmpty())
        return menu;
    for (const QAction* each : menu.actions()) {
        if (each->menu() && each->menu()->title() == action.submenu)
            return *each->menu();
    }
    return *menu.addMenu(action.submenu);
}

void addOverlaps(QMenu& menu, QAction* before, Workspace& workspace)
{
    auto* sub = new QMenu(QObject::tr("Add segment that may overlap"), &menu);
    sub->setObjectName(QStringLiteral("overlappingSegment"));
    sub->setToolTipsVisible(true);
    menu.insertMenu(before, sub);
    QObject::connect(
        &menu, &QMenu::aboutToShow, sub, [sub, &workspace] { listOverlaps(*sub, workspace); });
    listOverlaps(*sub, workspace);
}

namespace {

/// The entries of "Combine", each with its submenu at the end of a menu.
std::vector<Combination> combinationsIn(
    QMenu& menu, Workspace& workspace, const CombineChoice& choice)
{
    using How = core::CombineSegments::How;
    const auto add = [&](const char* name, How how, const QString& text, const QString& named) {
        auto* sub = new QMenu(&menu);
        sub->setObjectName(QLatin1String(name));
        menu.addMenu(sub);
        const auto edit = [&workspace, how](int label, int other) {
            const bool isMerged = how == How::Merge; // the other one receives the voxels
            return core::CombineSegments{.segment = isMerged ? other : label,
                .with = isMerged ? label : other,
                .how = how,
                .editable = workspace.editableRange()};
        };
        Combination made{sub, text, named,
            [edit, choose = choice.choose](int label, int other) { choose(edit(label, other)); }};
        if (how == How::Merge)
            made.kind = OtherSegment::Unlocked;
        else if (how != How::Swap)
            made.kind = OtherSegment::Overlapping;
        if (choice.pointedAt) {
            made.pointedAt = [edit, pointed = choice.pointedAt](int label, int other) {
                const core::CombineSegments meant = edit(label, other);
                pointed(other == 0 ? nullptr : &meant);
            };
            QObject::connect(sub->menuAction(), &QAction::hovered, sub,
                [pointed = choice.pointedAt] { pointed(nullptr); });
            // A key that leads out of the submenu points at nothing else; this menu stays open
            // then, as it does not when an entry is chosen.
            QObject::connect(
                sub, &QMenu::aboutToHide, sub,
                [&menu, sub, pointed = choice.pointedAt] {
                    if (menu.isVisible() && menu.activeAction() == sub->menuAction())
                        pointed(nullptr);
                },
                Qt::QueuedConnection);
        }
        return made;
    };
    return {
        add("mergeSegments", How::Merge, QObject::tr("Merge into"), QObject::tr("Merge '%1' into")),
        add("swapSegments", How::Swap, QObject::tr("Swap with"), QObject::tr("Swap '%1' with")),
        add("uniteSegments", How::Union, QObject::tr("Add voxels of"),
            QObject::tr("Add to '%1' voxels of")),
        add("subtractSegment", How::Subtract, QObject::tr("Subtract"),
            QObject::tr("Subtract from '%1'")),
        add("intersectSegments", How::Intersect, QObject::tr("Intersect with"),
            QObject::tr("Intersect '%1' with"))};
}

/// Has them listed now, and whenever the menu opens.
void listThem(QMenu& menu, Workspace& workspace, const std::vector<Combination>& all,
    const std::function<int()>& label, bool named)
{
    const auto list = [&workspace, all, label, named] {
        for (const Combination& each : all)
            each.list(workspace, label(), named);
    };
    QObject::connect(&menu, &QMenu::aboutToShow, all.front().menu, list);
    list();
}

} // namespace

void addCombineEntries(QMenu& menu, Workspace& workspace, const std::function<int()>& label,
    const CombineChoice& choice)
{
    menu.setToolTipsVisible(true);
    listThem(menu, workspace, combinationsIn(menu, workspace, choice), label, false);
}

void addCombinations(QMenu& menu, QAction* before, Workspace& workspace,
    const std::function<int()>& label, bool named)
{
    menu.setToolTipsVisible(true);
    addEditableNote(menu, before, workspace);
    // In the menu itself they would make it higher than small screens.
    auto* combine = new QMenu(QObject::tr("Combine"), &menu);
    combine->setObjectName(QStringLiteral("combineSegments"));
    combine->setToolTipsVisible(true);
    menu.insertMenu(before, combine);
    std::vector<Combination> all = combinationsIn(
        *combine, workspace, {.choose = [&workspace](const core::CombineSegments& edit) {
            combineSegments(workspace, edit);
        }});
    auto* distance = new QMenu(&menu);
    distance->setObjectName(QStringLiteral("distanceOfSegments"));
    menu.insertMenu(before, distance);
    all.push_back(
        {distance, QObject::tr("Measure distance to"), QObject::tr("Measure distance from '%1' to"),
            [&workspace](int one, int other) { measureDistance(workspace, one, other); },
            OtherSegment::Any});
    listThem(menu, workspace, all, label, named);
}

} // namespace ui
