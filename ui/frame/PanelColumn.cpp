// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/PanelColumn.h"

#include "ui/frame/Panel.h"

#include <QScrollBar>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

QString key(const PanelSection& section, const char* what)
{
    return QStringLiteral("panels/%1/%2").arg(section.id(), QLatin1String(what));
}

} // namespace

PanelColumn::PanelColumn(QWidget* parent)
    : QScrollArea(parent)
    , m_layout(nullptr)
{
    auto* content = new QFrame(this);
    content->setProperty("role", QStringLiteral("panel"));
    m_layout = new QVBoxLayout(content);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(2);
    // What nothing stretches into, when all lists are folded.
    m_layout->addStretch(0);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumWidth(leastWidth);
    setMaximumWidth(2 * leastWidth);
}

QSize PanelColumn::sizeHint() const
{
    return {leastWidth, QScrollArea::sizeHint().height()};
}

PanelSection& PanelColumn::add(ui::Panel* panel)
{
    auto* section = new PanelSection(*panel, this);
    m_places.push_back({section});
    putBack(*section);
    // A folded list leaves its share to the others.
    connect(section, &PanelSection::folded, this, [this, section, panel](bool folded) {
        m_layout->setStretchFactor(section, panel->stretches() && !folded ? 1 : 0);
    });
    connect(panel, &Panel::hasSomethingChanged, this, &PanelColumn::update);
    connect(section, &PanelSection::floatRequested, this,
        [this, section](bool floating) { setFloating(*section, floating); });
    return *section;
}

void PanelColumn::putBack(PanelSection& section)
{
    int position = 0;
    for (const Place& place : m_places) {
        if (place.section == &section)
            break;
        position += place.section->isFloating() ? 0 : 1;
    }
    const bool stretches = section.panel().stretches() && !section.isFolded();
    section.becomePart(widget());
    m_layout->insertWidget(position, &section, stretches ? 1 : 0);
}

bool PanelColumn::isWanted(const PanelSection& section) const
{
    return std::any_of(m_places.begin(), m_places.end(),
        [&](const Place& place) { return place.section == &section && place.wanted; });
}

void PanelColumn::setWanted(PanelSection& section, bool wanted)
{
    for (Place& place : m_places) {
        if (place.section == &section)
            place.wanted = wanted;
    }
    update();
}

void PanelColumn::setFloating(PanelSection& section, bool floating)
{
    if (floating == section.isFloating())
        return;
    if (floating) {
        // Beside where it was, so that it is seen to have left.
        const QPoint corner = section.mapToGlobal(QPoint(-PanelSection::leastWidth - 24, 0));
        m_layout->removeWidget(&section);
        section.becomeWindow(window());
        section.move(corner);
    } else {
        putBack(section);
    }
    update();
}

void PanelColumn::bringUp(const ui::Panel& panel)
{
    for (Place& place : m_places) {
        if (&place.section->panel() != &panel)
            continue;
        place.wanted = true;
        place.section->setFolded(false);
        update();
        // Once what was unfolded has its height.
        QTimer::singleShot(0, place.section, [this, section = place.section] {
            if (section->isFloating())
                return;
            ensureWidgetVisible(section, 0, 0);
            if (section->height() > viewport()->height())
                verticalScrollBar()->setValue(section->y());
        });
    }
}

void PanelColumn::showAll(bool shown)
{
    m_shown = shown;
    update();
}

void PanelColumn::setUsable(bool usable)
{
    for (const Place& place : m_places)
        place.section->setEnabled(usable);
}

void PanelColumn::reset()
{
    for (Place& place : m_places) {
        place.wanted = true;
        place.section->setFolded(place.section->panel().foldedAtFirst());
        if (place.section->isFloating())
            putBack(*place.section);
    }
    update();
}

void PanelColumn::update()
{
    bool any = false;
    for (const Place& place : m_places) {
        const bool wanted = place.wanted && place.section->panel().hasSomething();
        place.section->setVisible(wanted && (m_shown || !place.section->isFloating()));
        any = any || (wanted && !place.section->isFloating());
    }
    setVisible(m_shown && any);
    Q_EMIT changed();
}

void PanelColumn::save(QSettings& settings) const
{
    for (const Place& place : m_places) {
        const PanelSection& section = *place.section;
        settings.setValue(key(section, "shown"), place.wanted);
        settings.setValue(key(section, "folded"), section.isFolded());
        settings.setValue(key(section, "floating"), section.isFloating());
        if (section.isFloating())
            settings.setValue(key(section, "geometry"), section.saveGeometry());
    }
}

void PanelColumn::restore(const QSettings& settings)
{
    for (Place& place : m_places) {
        PanelSection& section = *place.section;
        place.wanted = settings.value(key(section, "shown"), true).toBool();
        section.setFolded(
            settings.value(key(section, "folded"), section.panel().foldedAtFirst()).toBool());
        setFloating(section, settings.value(key(section, "floating"), false).toBool());
        if (section.isFloating())
            section.restoreGeometry(settings.value(key(section, "geometry")).toByteArray());
    }
    update();
}

} // namespace ui
