// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/refine/ChunksPanel.h"

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/masks/MaskOnVolume.h"
#include "core/session/EditSession.h"
#include "core/titles/RowTitle.h"
#include "ui/base/NumberText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/Theme.h"
#include "ui/panels/refine/LikelySection.h"
#include "ui/texts/ProgressTexts.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace ui {

namespace {

constexpr int askingMs = 100;

int sliderOf(int count)
{
    return int(std::lround(100.0 * std::log(double(count))));
}

int countOf(int slider)
{
    return std::clamp(
        int(std::lround(std::exp(double(slider) / 100.0))), Chunks::fewest, Chunks::most);
}

/// Whether the last step has added chunks.
bool hasJustAdded(const core::EditSession* session)
{
    if (!session || session->history().position() == 0)
        return false;
    const core::HistoryRow& row = session->history().row(session->history().position());
    return row.edit.is<core::ChunkToggle>() && row.title
        && row.title->code != core::RowTitleCode::TakeChunks;
}

} // namespace

ChunksPanel::ChunksPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    layout->setSpacing(theme::smallPadding);
    buildDividing();
    buildLook();
    connect(&workspace.chunks(), &Chunks::changed, this, &ChunksPanel::show);
    connect(&workspace.chunks(), &Chunks::lookChanged, this, &ChunksPanel::show);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &ChunksPanel::show);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Labels)
                show(); // a segment may have voxels now
            else if (change.what == core::DocumentChange::What::History)
                showHint();
        });
    show();
}

void ChunksPanel::buildDividing()
{
    m_whose = smallText({}, this);
    m_whose->setObjectName(QStringLiteral("chunksWhose"));
    m_whose->setProperty("role", QStringLiteral("secondary"));
    layout()->addWidget(m_whose);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    m_margin = new NumberField(this);
    m_margin->setObjectName(QStringLiteral("chunksMargin"));
    m_margin->setAccessibleName(tr("Margin"));
    m_margin->setRange(0.0, 200.0);
    m_margin->setDecimals(1);
    m_margin->setSingleStep(5.0);
    m_margin->setPrefix(tr("and "));
    m_margin->setSuffix(tr(" mm around"));
    m_margin->setValue(core::DivideSegment().marginMm);
    m_margin->setToolTip(tr("How far beyond the segment chunks are looked for, on all sides. Until "
                            "you set it, it is a third of the segment's diameter."));
    m_divide = new QPushButton(tr("Divide"), this);
    m_divide->setObjectName(QStringLiteral("divide"));
    row->addWidget(m_margin, 1);
    row->addWidget(m_divide);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    connect(m_divide, &QPushButton::clicked, this, [this] {
        m_workspace.chunks().divide(m_margin->value(), m_source->currentData().toString());
    });
    connect(m_margin, &QDoubleSpinBox::valueChanged, this, [this] { m_marginByHand = true; });
    buildSource();

    m_waiting = new QWidget(this);
    auto* waiting = new QGridLayout(m_waiting);
    waiting->setContentsMargins(0, 0, 0, 0);
    waiting->setSpacing(theme::smallPadding);
    waiting->setColumnStretch(0, 1);
    m_progress = new QProgressBar(m_waiting);
    m_progress->setObjectName(QStringLiteral("chunksProgress"));
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_step = smallText({}, m_waiting);
    m_step->setObjectName(QStringLiteral("chunksStep"));
    m_step->setProperty("role", QStringLiteral("secondary"));
    auto* abort = new QPushButton(tr("Abort"), m_waiting);
    abort->setObjectName(QStringLiteral("chunksAbort"));
    waiting->addWidget(m_step, 0, 0);
    waiting->addWidget(m_progress, 1, 0);
    waiting->addWidget(abort, 0, 1, 2, 1);
    layout()->addWidget(m_waiting);
    connect(abort, &QPushButton::clicked, &m_workspace.chunks(), &Chunks::abort);
    m_asking.setInterval(askingMs);
    connect(&m_asking, &QTimer::timeout, this, &ChunksPanel::showStage);
}

void ChunksPanel::buildSource()
{
    m_source = new QComboBox(this);
    m_source->setObjectName(QStringLiteral("chunksSource"));
    m_source->setAccessibleName(tr("By"));
    m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_source->setToolTip(
        tr("What says how likely a voxel belongs to the segment: the image alone, or also a "
           "probability map that another program has made, as a DICOM SEG of type FRACTIONAL, or "
           "as numbers from 0 to 1 in NIfTI, NRRD or MetaImage"));
    m_source->addItem(tr("by the image alone"));
    m_source->addItem(tr("by a probability map …"));
    layout()->addWidget(m_source);
    // The last entry asks for a file; what is in between are the files that were chosen.
    connect(m_source, &QComboBox::activated, this, [this](int chosen) {
        if (chosen + 1 == m_source->count())
            return chooseMap();
        m_chosenSource = chosen;
    });
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_marginByHand = false;
        while (m_source->count() > 2)
            m_source->removeItem(1);
        m_source->setCurrentIndex(0);
        m_chosenSource = 0;
        show();
    });
}

void ChunksPanel::suitMargin(const core::Segment& segment)
{
    if (m_marginByHand || segment.voxels <= 0)
        return;
    const QSignalBlocker blocker(m_margin);
    m_margin->setValue(
        core::ChunkMap::suitableMarginMm(segment.voxels, m_workspace.volume()->geometry));
}

void ChunksPanel::chooseMap()
{
    m_source->setCurrentIndex(m_chosenSource);
    const QString path = QFileDialog::getOpenFileName(window(), tr("Probability map"), QString(),
        tr("Probability maps (%1);;All files (*)")
            .arg(core::maskNamePatterns().join(QLatin1Char(' '))));
    if (path.isEmpty())
        return;
    int place = m_source->findData(path);
    if (place < 0) {
        place = m_source->count() - 1;
        m_source->insertItem(place, tr("by %1").arg(QFileInfo(path).fileName()), path);
    }
    m_source->setCurrentIndex(place);
    m_chosenSource = place;
}

void ChunksPanel::buildLook()
{
    m_looks = new QWidget(this);
    auto* column = new QVBoxLayout(m_looks);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme::smallPadding);
    m_shown = new QCheckBox(tr("show chunks"), m_looks);
    m_shown->setObjectName(QStringLiteral("chunksShown"));
    m_state = smallText({}, m_looks);
    m_state->setObjectName(QStringLiteral("chunksState"));
    column->addWidget(m_shown);
    column->addWidget(m_state);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const auto slider = [this, grid](
                            int row, const QString& text, const char* name, const QString& widest) {
        auto* made = new QSlider(Qt::Horizontal, m_looks);
        made->setObjectName(QLatin1String(name));
        made->setAccessibleName(text);
        auto* value = smallText({}, m_looks);
        value->setWordWrap(false);
        value->setProperty("role", QStringLiteral("secondary"));
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setMinimumWidth(value->fontMetrics().horizontalAdvance(widest));
        grid->addWidget(smallText(text, m_looks), row, 0);
        grid->addWidget(made, row, 1);
        grid->addWidget(value, row, 2);
        return std::pair(made, value);
    };
    std::tie(m_count, m_countText) = slider(0, tr("Chunks"), "chunkCount", countText(Chunks::most));
    m_count->setRange(sliderOf(Chunks::fewest), sliderOf(Chunks::most));
    m_count->setSingleStep(10);
    m_count->setPageStep(50);
    m_count->setToolTip(tr("Few large chunks, or many small ones; those that hang together least "
                           "stay apart longest"));
    std::tie(m_opacity, m_opacityText) =
        slider(1, tr("Opacity"), "chunkOpacity", tr("%1 %").arg(100));
    m_opacity->setRange(5, 100);
    m_bodies = new QComboBox(m_looks);
    m_bodies->setObjectName(QStringLiteral("chunkBodies"));
    m_bodies->setAccessibleName(tr("In 3D"));
    m_bodies->addItems({tr("the segment's"), tr("and what looks like it"), tr("all")});
    m_bodies->setToolTip(tr("Which chunks the 3D view shows; slices show all"));
    grid->addWidget(smallText(tr("In 3D"), m_looks), 2, 0);
    grid->addWidget(m_bodies, 2, 1, 1, 2);
    column->addLayout(grid);
    column->addWidget(new LikelySection(m_workspace, m_looks));
    m_hint = smallText({}, m_looks);
    m_hint->setObjectName(QStringLiteral("chunksHint"));
    m_hint->setProperty("role", QStringLiteral("secondary"));
    column->addWidget(m_hint);
    layout()->addWidget(m_looks);
    connect(m_shown, &QCheckBox::toggled, this, &ChunksPanel::takeLook);
    connect(m_count, &QSlider::valueChanged, this, &ChunksPanel::takeLook);
    connect(m_opacity, &QSlider::valueChanged, this, &ChunksPanel::takeLook);
    connect(m_bodies, &QComboBox::activated, this, &ChunksPanel::takeLook);
}

QString ChunksPanel::title() const
{
    return tr("Chunks");
}

QString ChunksPanel::summary() const
{
    const Chunks& chunks = m_workspace.chunks();
    if (chunks.isWorking())
        return tr("working …");
    return chunks.map() ? tr("%1 chunks").arg(countText(chunks.shownCount())) : QString();
}

void ChunksPanel::show()
{
    const Chunks& chunks = m_workspace.chunks();
    const core::EditSession* session = m_workspace.session();
    const auto division = chunks.division();
    const core::Segment* active =
        session ? session->document().segment(m_workspace.activeSegment()) : nullptr;
    const core::Segment* divided =
        division ? session->document().segment(division->segment) : nullptr;
    if (active)
        suitMargin(*active);
    m_divide->setEnabled(active && active->voxels > 0 && !chunks.isReading());
    m_whose->setText(!active ? tr("Choose the segment to repair in the list of segments.")
            : active->voxels == 0
            ? tr("%1 has no voxels yet: grow, paint or import it first.").arg(active->name)
            : tr("Divide %1 and what lies around it into regions that hang together, to be added "
                 "or taken away with a click.")
                  .arg(active->name));
    m_waiting->setVisible(chunks.isWorking());
    if (!chunks.isWorking()) {
        m_asking.stop();
    } else if (!m_asking.isActive()) {
        showStage();
        m_asking.start();
    }
    m_looks->setVisible(divided && !chunks.isWorking());
    if (divided) {
        const Chunks::Look& look = chunks.look();
        const QSignalBlocker shown(m_shown);
        const QSignalBlocker count(m_count);
        const QSignalBlocker opacity(m_opacity);
        m_shown->setChecked(look.shown);
        m_count->setValue(sliderOf(look.count));
        m_countText->setText(countText(chunks.map() ? chunks.shownCount() : look.count));
        m_opacity->setValue(int(std::lround(100.0f * look.opacity)));
        m_opacityText->setText(tr("%1 %").arg(m_opacity->value()));
        m_bodies->setCurrentIndex(int(look.bodies));
        m_state->setText(chunks.map() ? tr("%1 has %2 of %3 chunks")
                                            .arg(divided->name, countText(chunks.ownCount()),
                                                countText(chunks.shownCount()))
                                      : tr("%1 is divided").arg(divided->name));
    }
    showHint();
    Q_EMIT summaryChanged(summary());
}

void ChunksPanel::showHint()
{
    m_hint->setText(hasJustAdded(m_workspace.session())
            ? tr("Too much came along? Press [ until that part is a chunk by itself: a click "
                 "takes it away again. ] joins chunks.")
            : tr("Click on chunks with the tool Chunks (Shift+F): the strong ones are the "
                 "segment's. A plane of the panel Clipping lets you look inside."));
}

void ChunksPanel::showStage()
{
    const core::ChunkStage stage = m_workspace.chunks().stage();
    m_progress->setValue(stage.percent);
    m_step->setText(tr("%1 · %2 %").arg(progressText(stage.step)).arg(stage.percent));
}

void ChunksPanel::takeLook()
{
    Chunks::Look look = m_workspace.chunks().look();
    look.shown = m_shown->isChecked();
    // Only what was moved: the slider does not know every number.
    if (sliderOf(look.count) != m_count->value())
        look.count = countOf(m_count->value());
    look.opacity = float(m_opacity->value()) / 100.0f;
    look.bodies = Chunks::Bodies(m_bodies->currentIndex());
    m_workspace.chunks().setLook(look);
}

} // namespace ui
