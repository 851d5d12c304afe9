// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/FigurePanels.h"

#include <QPainter>

namespace test {

namespace {

QString wantedFolder()
{
    return qEnvironmentVariable("BURIN_SCREENSHOTS");
}

} // namespace

core::OrthographicView viewFrom(
    const glm::dvec3& direction, const glm::dvec3& target, double heightMm)
{
    return {.eyeLps = target + 300.0 * glm::normalize(direction),
        .targetLps = target,
        .up = {0.0, 0.0, 1.0},
        .heightMm = heightMm};
}

gpu::VolumeScene sceneOf(const core::OrthographicView& view)
{
    gpu::VolumeScene scene;
    scene.eyeLps = view.eyeLps;
    scene.targetLps = view.targetLps;
    scene.up = view.up;
    scene.heightMm = view.heightMm;
    return scene;
}

void drawSketch(QImage& picture, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& pathMm, bool closed, std::uint32_t rgb)
{
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const double perMm = picture.height() / view.heightMm;
    QPolygonF curve;
    for (const glm::dvec2& point : pathMm)
        curve << QPointF(
            picture.width() / 2.0 + perMm * point.x, picture.height() / 2.0 - perMm * point.y);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 4.0), QPen(QColor(rgb), 2.0)}) {
        painter.setPen(pen);
        if (closed)
            painter.drawPolygon(curve);
        else
            painter.drawPolyline(curve);
    }
}

bool panelsWanted()
{
    return !wantedFolder().isEmpty();
}

bool keepPanels(const std::vector<QImage>& panels, const char* name)
{
    if (!panelsWanted())
        return true;
    QImage all(int(panels.size()) * (panels.front().width() + 4) - 4, panels.front().height(),
        QImage::Format_RGB888);
    all.fill(0x404040);
    QPainter painter(&all);
    int x = 0;
    for (const QImage& panel : panels) {
        painter.drawImage(x, 0, panel);
        x += panel.width() + 4;
    }
    painter.end();
    return all.save(wantedFolder() + QLatin1Char('/') + QLatin1String(name));
}

} // namespace test
