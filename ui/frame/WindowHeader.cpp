// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/WindowHeader.h"

#include "core/session/EditSession.h"
#include "ui/base/Actions.h"
#include "ui/base/Icons.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/frame/ReadOnlyMark.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QMenuBar>
#include <QToolButton>

#include <initializer_list>

namespace ui {

namespace {

QStringList ids(std::initializer_list<const char*> names)
{
    QStringList list;
    for (const char* name : names)
        list += QLatin1String(name);
    return list;
}

} // namespace

QStringList layoutIds()
{
    return ids({"view.four", "view.penAndStage", "view.volume", "view.axial", "view.sagittal",
        "view.coronal", "view.plane", "view.penApart"});
}

WindowHeader::WindowHeader(Workspace& workspace, QWidget* parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_menuBar(new QMenuBar(this))
    , m_identity(new FittingLabel(Qt::AlignRight, this))
    , m_layouts(new QToolButton(this))
{
    m_layouts->setObjectName(QStringLiteral("layouts"));
    m_layouts->setText(tr("Layout"));
    m_layouts->setToolTip(tr("Which views are shown"));
    m_layouts->setIcon(stateIcon(QStringLiteral("restore-grid")));
    m_layouts->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_layouts->setPopupMode(QToolButton::InstantPopup);
    m_layouts->setFont(theme::smallFont());
    m_layouts->setFocusPolicy(Qt::NoFocus);
    m_layouts->hide();
    m_identity->setFont(theme::smallFont());
    m_identity->setProperty("role", QStringLiteral("secondary"));
    m_identity->setContentsMargins(0, 0, theme::padding, 0);

    setProperty("role", QStringLiteral("panel"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::padding);
    m_menuBar->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    row->addWidget(m_menuBar);
    row->addWidget(new ReadOnlyMark(m_workspace, this));
    row->addWidget(m_identity, 1);
    row->addWidget(m_layouts);
}

void WindowHeader::fillMenus(Actions& actions, const QStringList& plane, const QStringList& stage)
{
    m_fileMenu = m_menuBar->addMenu(QStringLiteral("&File"));
    actions.fill(*m_fileMenu,
        ids({"file.openFolder", "file.openFile", "file.openSession", "file.fromPacs",
            "file.demonstration", "", "file.importMask", "file.importMaskFolder", "", "file.saveAs",
            "file.auditReport", "", "file.toPacs", "", "file.close", "file.quit"}));
    m_editMenu = m_menuBar->addMenu(QStringLiteral("&Edit"));
    actions.fill(*m_editMenu,
        ids({"edit.undo", "edit.redo", "edit.undoOnlySegment", "", "edit.author",
            "edit.historyMemory"}));
    fillViewMenu(actions, plane, stage);
    m_sculptMenu = m_menuBar->addMenu(QStringLiteral("S&culpt"));
    m_growMenu = m_menuBar->addMenu(QStringLiteral("&Grow"));
    m_refineMenu = m_menuBar->addMenu(QStringLiteral("&Refine"));
    m_segmentsMenu = m_menuBar->addMenu(QStringLiteral("&Segments"));
    actions.fill(*m_segmentsMenu,
        ids({"segments.add", "", "segments.previous", "segments.next", "segments.underPointer",
            "segments.centre", "segments.alone", ""}));
    for (const SegmentAction& action : segmentActions())
        actions.fill(menuOf(*m_segmentsMenu, action), {QLatin1String(action.id)});
    QMenu* help = m_menuBar->addMenu(QStringLiteral("&Help"));
    actions.fill(*help, ids({"help.keys", "help.pen", "help.about"}));
}

void WindowHeader::fillViewMenu(
    Actions& actions, const QStringList& plane, const QStringList& stage)
{
    QMenu* view = m_menuBar->addMenu(QStringLiteral("&View"));
    actions.fill(*view->addMenu(tr("Layout")), layoutIds());
    auto* layouts = new QMenu(m_layouts);
    actions.fill(*layouts, layoutIds());
    m_layouts->setMenu(layouts);
    actions.fill(
        *view, ids({"", "view.reset", "view.resetAll", "view.linkedPlaces", "", "view.bookmark"}));
    m_bookmarksMenu = view->addMenu(tr("Bookmarks"));
    view->addSeparator();
    QMenu* grey = view->addMenu(tr("Grey scale"));
    for (int number = 1; number <= 9; ++number)
        grey->addAction(&actions[QStringLiteral("window.preset%1").arg(number)]);
    grey->addSeparator();
    grey->addAction(&actions[QStringLiteral("window.box")]);
    grey->addAction(&actions[QStringLiteral("view.inverted")]);
    actions.fill(*view->addMenu(tr("Colours")),
        ids({"view.coloursGrey", "view.coloursHotIron", "view.coloursHotMetalBlue",
            "view.coloursPet20Step", "view.coloursEvenLightness", "", "view.inverted"}));
    actions.fill(*view->addMenu(tr("Interpolation")),
        ids({"view.interpolationUsual", "", "view.interpolationNearest", "view.interpolationLinear",
            "view.interpolationCubic"}));
    actions.fill(*view->addMenu(tr("Flip and turn slice")),
        ids({"view.flipLeftRight", "view.flipTopBottom", "view.quarterRight", "view.quarterLeft",
            "", "view.upright", "", "view.alongPatient"}));
    actions.fill(*view->addMenu(tr("Slab")),
        ids({"view.slabOff", "view.slabMip", "view.slabMinip", "view.slabMean"}));
    QMenu* volume = view->addMenu(QStringLiteral("3D"));
    actions.fill(*volume,
        ids({"view.surface", "view.dvr", "view.mip", "view.xray", "", "view.contextOpaque",
            "view.contextTranslucent", "view.contextCutAway", "view.contextHidden", "",
            "view.fromFront", "view.fromBack", "view.fromLeft", "view.fromRight", "view.fromAbove",
            "view.fromBelow"}));
    actions.fill(*view->addMenu(tr("Stage")), stage);
    actions.fill(*view->addMenu(tr("Cutting plane")), plane);
    actions.fill(*view->addMenu(tr("Segments in slices")),
        ids({"segments.fillAndOutline", "segments.fill", "segments.outline", "",
            "segments.fillMore", "segments.fillLess"}));
    actions.fill(*view->addMenu(tr("Segments in 3D")),
        ids({"segments.smoothBodies", "segments.voxelTrueBodies"}));
    view->addSeparator();
    actions.fill(*view->addMenu(tr("Show")),
        ids({"view.crosshair", "view.referenceLines", "view.patient", "view.segments",
            "view.carved", "view.hole", "view.barriers"}));
    m_panelsMenu = view->addMenu(tr("Panels"));
    actions.fill(*m_panelsMenu, ids({"view.panels", "view.resetPanels", ""}));
    actions.fill(*view, ids({"view.fullScreen"}));
}

void WindowHeader::showIdentity(const core::Volume* volume)
{
    m_layouts->setVisible(volume != nullptr);
    if (!volume) {
        window()->setWindowTitle(QStringLiteral("Burin"));
        m_identity->clear();
        m_identity->setToolTip(QString());
        return;
    }
    QStringList parts{patientText(volume->identity), studyText(volume->identity),
        seriesText(volume->identity), timeText(*volume)};
    parts.removeAll(QString());
    const QString text = parts.join(QStringLiteral(" · "));
    const bool readOnly = m_workspace.session() && !m_workspace.session()->whyReadOnly().isEmpty();
    window()->setWindowTitle(text + (readOnly ? QStringLiteral(" (read-only)") : QString())
        + QStringLiteral(" — Burin"));
    m_identity->setToolTip(text);
    m_identity->setText(text);
}

} // namespace ui
