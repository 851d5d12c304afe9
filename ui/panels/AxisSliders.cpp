// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/AxisSliders.h"

#include "ui/base/SmallLabel.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/widgets/RangeSlider.h"

#include <QGridLayout>
#include <QLabel>

namespace ui {

void AxisSliders::build(QWidget* parent, QGridLayout& grid, const QString& name)
{
    for (int axis = 0; axis < 3; ++axis) {
        Row& row = m_rows[std::size_t(axis)];
        row.low = smallNote({}, parent);
        row.high = smallNote({}, parent, Qt::AlignRight);
        row.slider = new RangeSlider(parent);
        row.slider->setObjectName(name + QString::number(axis));
        grid.addWidget(row.low, axis, 0);
        grid.addWidget(row.slider, axis, 1);
        grid.addWidget(row.high, axis, 2);
    }
    grid.setColumnStretch(1, 1);
}

void AxisSliders::showVolume(const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    const glm::dmat3 direction = geometry.direction();
    for (int axis = 0; axis < 3; ++axis) {
        const Row& row = m_rows[std::size_t(axis)];
        row.low->setText(directionLetters(-direction[axis]));
        row.high->setText(directionLetters(direction[axis]));
        row.slider->setBounds(0.0, geometry.size[axis] * spacing[axis], spacing[axis]);
    }
}

void AxisSliders::showBox(const core::ClipRegion::Box& box, const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    for (int axis = 0; axis < 3; ++axis)
        of(axis)->setValues(
            (box.minimum[axis] + 0.5) * spacing[axis], (box.maximum[axis] + 0.5) * spacing[axis]);
}

} // namespace ui
