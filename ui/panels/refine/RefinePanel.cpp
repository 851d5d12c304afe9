// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/RefinePanel.h"

#include "core/edits/kinds/surface/LaySurface.h"
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/mesh/SurfaceFile.h"
#include "core/session/SessionSurface.h"
#include "ui/base/NumberText.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/SuggestedTarget.h"
#include "ui/menus/EditableButton.h"
#include "ui/panels/refine/DoubtsSection.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int mostErrorRows = 4;
constexpr int fewestVertices = 1000;
constexpr int vertexStep = 1000;

QString areaText(double areaMm2)
{
    return areaMm2 < 100.0 ? RefinePanel::tr("%1 mm²").arg(numberText(areaMm2, 0))
                           : RefinePanel::tr("%1 cm²").arg(numberText(areaMm2 / 100.0, 1));
}

} // namespace

RefinePanel::RefinePanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    // Not as pages of a stack, which is always as tall as the tallest.
    m_laying = buildLaying();
    m_refining = buildRefining();
    layout->addWidget(m_laying);
    layout->addWidget(m_refining);
    m_abort = new QPushButton(tr("Abort"), this);
    m_abort->setObjectName(QStringLiteral("abortSurface"));
    m_abort->setToolTip(tr("Nothing changes"));
    m_abort->hide();
    layout->addWidget(m_abort);
    connect(m_abort, &QPushButton::clicked, this, [this] { m_workspace.refinement().abort(); });
    constexpr int watchMs = 100;
    m_watching.setInterval(watchMs);
    connect(&m_watching, &QTimer::timeout, this, &RefinePanel::watch);
    connect(&workspace.refinement(), &Refinement::changed, this, &RefinePanel::show);
    connect(&workspace.refinement(), &Refinement::lookChanged, this, &RefinePanel::show);
    connect(&workspace.refinement(), &Refinement::contoursChanged, this, &RefinePanel::show);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &RefinePanel::show);
    connect(&workspace, &Workspace::sessionChanged, this, &RefinePanel::show);
    show();
}

QWidget* RefinePanel::buildLaying()
{
    auto* page = new QWidget(this);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_whose = smallText({}, page);
    m_whose->setProperty("role", QStringLiteral("secondary"));
    layout->addWidget(m_whose);
    m_vertices = new WholeNumberField(page);
    m_vertices->setObjectName(QStringLiteral("surfaceVertices"));
    m_vertices->setAccessibleName(tr("Vertices"));
    m_vertices->setRange(fewestVertices - vertexStep, core::mostVertices);
    m_vertices->setSingleStep(vertexStep);
    m_vertices->setGroupSeparatorShown(true);
    m_vertices->setSpecialValueText(tr("as many as it takes"));
    m_vertices->setValue(m_vertices->minimum());
    m_vertices->setSuffix(tr(" vertices"));
    m_vertices->setToolTip(tr("How fine the surface is. As many vertices as it takes: it encloses "
                              "what the segment holds, but for a thousandth"));
    m_lay = new QPushButton(tr("Lay surface"), page);
    m_lay->setObjectName(QStringLiteral("laySurface"));
    layout->addWidget(m_vertices);
    layout->addWidget(m_lay);
    connect(m_lay, &QPushButton::clicked, this, [this] {
        const int asked = m_vertices->value();
        m_workspace.refinement().lay(asked < fewestVertices ? 0 : asked);
    });
    return page;
}

QWidget* RefinePanel::buildRefining()
{
    auto* page = new QWidget(this);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_state = smallText({}, page);
    m_state->setObjectName(QStringLiteral("surfaceState"));
    layout->addWidget(m_state);
    // For writing back; the surface itself may go anywhere.
    layout->addWidget(new EditableButton(m_workspace, page, EditableButton::In::Column));
    // Side by side they would not fit into the column.
    auto* buttons = new QGridLayout;
    buttons->setSpacing(theme::smallPadding);
    const auto button = [page](const QString& text, const char* name, const QString& tip) {
        auto* made = new QPushButton(text, page);
        made->setObjectName(QLatin1String(name));
        made->setToolTip(tip);
        return made;
    };
    m_write = button(tr("Write back"), "writeBack",
        tr("The segment follows the surface to where it was moved; all other voxels stay"));
    m_follow = button(tr("Follow mask"), "followMask",
        tr("What is yellow goes to the boundary of what the segment holds now"));
    m_drop = button(tr("Remove"), "dropSurface", tr("Do without the surface; undo brings it back"));
    auto* barrierButton = button(tr("Make barrier"), "surfaceBarrier",
        tr("No growth passes through the surface: the voxels just outside of it are shut"));
    auto* open = button(tr("Open barrier"), "openSurfaceBarrier",
        tr("Growth passes again: barriers just outside of the surface are taken away"));
    buttons->addWidget(m_write, 0, 0, 1, 2);
    buttons->addWidget(m_follow, 1, 0);
    buttons->addWidget(m_drop, 1, 1);
    buttons->addWidget(barrierButton, 2, 0);
    buttons->addWidget(open, 2, 1);
    m_save = button(tr("Save surface …"), "saveSurface",
        tr("Writes the surface itself as STL, PLY, OBJ or glTF, in patient coordinates"));
    buttons->addWidget(m_save, 3, 0, 1, 2);
    connect(m_save, &QPushButton::clicked, this, &RefinePanel::askWhereToSave);
    layout->addLayout(buttons);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    m_style = new QComboBox(page);
    m_style->setObjectName(QStringLiteral("surfaceStyle"));
    m_style->setAccessibleName(tr("Drawn"));
    m_style->addItems({tr("smooth"), tr("wireframe"), tr("grey values")});
    grid->addWidget(smallText(tr("Drawn"), page), 0, 0);
    grid->addWidget(m_style, 0, 1, 1, 2);
    m_opacity = new QSlider(Qt::Horizontal, page);
    m_opacity->setObjectName(QStringLiteral("surfaceOpacity"));
    m_opacity->setAccessibleName(tr("Opacity"));
    m_opacity->setRange(0, 100);
    m_opacityText = smallText({}, page);
    m_opacityText->setProperty("role", QStringLiteral("secondary"));
    m_opacityText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_opacityText->setMinimumWidth(
        m_opacityText->fontMetrics().horizontalAdvance(tr("%1 %").arg(100)));
    grid->addWidget(smallText(tr("Opacity"), page), 1, 0);
    grid->addWidget(m_opacity, 1, 1);
    grid->addWidget(m_opacityText, 1, 2);
    layout->addLayout(grid);
    auto* shown = new QHBoxLayout;
    m_marks = new QCheckBox(tr("marks"), page);
    m_marks->setObjectName(QStringLiteral("surfaceMarks"));
    m_contours = new QCheckBox(tr("contours on slices"), page);
    m_contours->setObjectName(QStringLiteral("surfaceContours"));
    shown->addWidget(m_marks);
    shown->addWidget(m_contours);
    shown->addStretch(1);
    layout->addLayout(shown);

    m_counts = smallText({}, page);
    m_counts->setObjectName(QStringLiteral("markCounts"));
    m_counts->setProperty("role", QStringLiteral("secondary"));
    layout->addWidget(m_counts);
    m_errors = new QListWidget(page);
    m_errors->setObjectName(QStringLiteral("surfaceErrors"));
    m_errors->setAccessibleName(tr("To check"));
    layout->addWidget(m_errors);
    m_signOff = button(tr("Sign off"), "signOffError",
        tr("The chosen place is right as it is now: it turns green, and nothing moves it"));
    layout->addWidget(m_signOff, 0, Qt::AlignRight);
    m_doubts = new DoubtsSection(m_workspace, page);
    layout->addWidget(m_doubts);

    Refinement& refinement = m_workspace.refinement();
    connect(m_write, &QPushButton::clicked, &refinement, &Refinement::writeBack);
    connect(m_follow, &QPushButton::clicked, &refinement, [this, &refinement] {
        refinement.followMask();
        // What stays although the mask went elsewhere is told of.
        m_doubts->doubts().look();
    });
    connect(m_drop, &QPushButton::clicked, &refinement, &Refinement::drop);
    connect(barrierButton, &QPushButton::clicked, &refinement,
        [&refinement] { refinement.makeBarrier(false); });
    connect(
        open, &QPushButton::clicked, &refinement, [&refinement] { refinement.makeBarrier(true); });
    connect(m_style, &QComboBox::activated, this, &RefinePanel::takeLook);
    connect(m_opacity, &QSlider::valueChanged, this, &RefinePanel::takeLook);
    connect(m_marks, &QCheckBox::toggled, this, &RefinePanel::takeLook);
    connect(m_contours, &QCheckBox::toggled, this, &RefinePanel::takeLook);
    connect(m_signOff, &QPushButton::clicked, this,
        [this] { m_workspace.refinement().signOff(m_errors->currentRow()); });
    connect(m_errors, &QListWidget::currentRowChanged, this,
        [this](int row) { m_signOff->setEnabled(row >= 0); });
    connect(m_errors, &QListWidget::itemActivated, this,
        [this](QListWidgetItem* item) { m_workspace.refinement().showError(m_errors->row(item)); });
    connect(m_errors, &QListWidget::itemClicked, this,
        [this](QListWidgetItem* item) { m_workspace.refinement().showError(m_errors->row(item)); });
    return page;
}

QString RefinePanel::title() const
{
    return tr("Refine");
}

QString RefinePanel::summary() const
{
    const Refinement& refinement = m_workspace.refinement();
    const std::optional<core::RefinedSurface> surface = refinement.surface();
    if (!surface)
        return {};
    return surface->isApart()
        ? tr("differs from the segment")
        : tr("%1 vertices").arg(countText(qulonglong(refinement.mirror().vertexCount())));
}

QString RefinePanel::asLaidText() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return {};
    const core::History& history = session->history();
    core::RowId id = history.position();
    const auto isLaid = [&history](core::RowId row) {
        const auto* lay = history.row(row).edit.as<core::LaySurface>();
        return lay && core::beginsSurface(*lay);
    };
    while (id != 0 && !isLaid(id))
        id = history.row(id).parent;
    return id == 0 ? QString() : nameOf(history.row(id));
}

void RefinePanel::show()
{
    const Refinement& refinement = m_workspace.refinement();
    const core::EditSession* session = m_workspace.session();
    const std::optional<core::RefinedSurface> surface = refinement.surface();
    m_laying->setVisible(!surface);
    m_refining->setVisible(surface.has_value());
    if (session && !session->idle())
        m_watching.start();
    const core::Segment* segment = session
        ? session->document().segment(surface ? surface->segment : m_workspace.activeSegment())
        : nullptr;
    m_lay->setEnabled(segment != nullptr);
    m_whose->setText(segment
            ? tr("Repair %1 instead of redrawing it: a surface around it is marked, pushed and "
                 "written back.")
                  .arg(segment->name)
            : tr("Choose the segment to repair in the list of segments."));
    if (surface) {
        const QString name = segment ? segment->name : QString();
        m_state->setText(surface->isApart()
                ? tr("%1: the segment does not hold what the surface encloses").arg(name)
                : asLaidText());
        m_state->setProperty(
            "role", surface->isApart() ? QStringLiteral("caution") : QStringLiteral("plain"));
        m_state->setStyleSheet(surface->isApart()
                ? QStringLiteral("color: %1").arg(theme::caution.name())
                : QString());
        m_write->setEnabled(surface->isApart());
        const Refinement::Look& look = refinement.look();
        const QSignalBlocker style(m_style);
        const QSignalBlocker opacity(m_opacity);
        const QSignalBlocker marks(m_marks);
        const QSignalBlocker contours(m_contours);
        m_style->setCurrentIndex(int(look.style));
        m_opacity->setValue(int(std::lround(100.0f * look.opacity)));
        m_opacityText->setText(tr("%1 %").arg(m_opacity->value()));
        m_marks->setChecked(look.showMarks);
        m_contours->setChecked(look.contours);
        showErrors();
    }
    Q_EMIT summaryChanged(summary());
}

void RefinePanel::showErrors()
{
    const Refinement& refinement = m_workspace.refinement();
    const std::array<std::size_t, 3> counts = refinement.mirror().markCounts();
    const double all = std::max<double>(1.0, double(refinement.mirror().vertexCount()));
    const auto share = [&](core::SurfaceMark mark) {
        return numberText(100.0 * double(counts[std::size_t(mark)]) / all, 1);
    };
    m_counts->setText(tr("green %1 %, red %2 %, the rest follows the mask")
                          .arg(share(core::SurfaceMark::Green), share(core::SurfaceMark::Red)));
    const std::vector<core::MarkedRegion>& errors = refinement.errors();
    const int current = m_errors->currentRow();
    const QSignalBlocker blocker(m_errors);
    m_errors->clear();
    for (std::size_t i = 0; i < errors.size(); ++i)
        m_errors->addItem(tr("To check %1 · %2").arg(i + 1).arg(areaText(errors[i].areaMm2)));
    m_errors->setCurrentRow(std::min(current, m_errors->count() - 1));
    m_errors->setVisible(!errors.empty());
    m_signOff->setVisible(!errors.empty());
    m_signOff->setEnabled(m_errors->currentRow() >= 0);
    const int rowHeight = std::max(m_errors->sizeHintForRow(0), theme::controlHeight);
    m_errors->setFixedHeight(
        rowHeight * std::clamp(m_errors->count(), 1, mostErrorRows) + 2 * m_errors->frameWidth());
}

/// Until what was asked for is done: the session tells of its end only where something changed.
void RefinePanel::watch()
{
    const core::EditSession* session = m_workspace.session();
    if (!session || session->idle())
        m_watching.stop();
    m_abort->setVisible(m_workspace.refinement().isAbortable());
}

void RefinePanel::askWhereToSave()
{
    QStringList patterns;
    for (const QString& ending : core::surfaceFileEndings())
        patterns += QStringLiteral("*.") + ending;
    const core::EditSession* session = m_workspace.session();
    const std::optional<core::RefinedSurface> surface = m_workspace.refinement().surface();
    const core::Segment* segment =
        session && surface ? session->document().segment(surface->segment) : nullptr;
    const auto chosen =
        askForTarget({.title = tr("Save surface"),
                         .of = segment ? tr("%1 surface").arg(segment->name) : tr("surface"),
                         .ending = QStringLiteral(".stl"),
                         .filter = tr("Surfaces (%1)").arg(patterns.join(u' '))},
            m_workspace.volume(), this);
    if (chosen)
        save(chosen->file);
}

void RefinePanel::save(const QString& path)
{
    core::EditSession* session = m_workspace.session();
    const core::SimplexMesh* mesh = session ? session->surface().mesh() : nullptr;
    const std::optional<core::RefinedSurface> surface = m_workspace.refinement().surface();
    const core::Segment* segment =
        mesh && surface ? session->document().segment(surface->segment) : nullptr;
    if (!segment)
        return m_workspace.say(tr("The surface is still being changed; save it in a moment"));
    const core::SurfaceFileFacts facts{
        .name = segment->name, .rgb = segment->rgb, .label = segment->label};
    m_saver.start(
        this, [copy = *mesh, facts, path] { return writeSurfaceFile(copy, facts, path, true); },
        [this, path](const core::Result<void>& written) {
            if (written)
                m_workspace.say(tr("The surface is in %1").arg(path));
            else
                m_workspace.fail(written.error());
        });
}

void RefinePanel::takeLook()
{
    m_workspace.refinement().setLook({.style = gpu::SurfaceStyle(m_style->currentIndex()),
        .opacity = float(m_opacity->value()) / 100.0f,
        .showMarks = m_marks->isChecked(),
        .contours = m_contours->isChecked()});
}

} // namespace ui
