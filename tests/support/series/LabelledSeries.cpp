// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/LabelledSeries.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QCryptographicHash>
#include <QDir>
#include <QTest>

#include <utility>

namespace test {

namespace {

SmallSeries placed(const glm::dmat3& directions, const glm::dvec3& shear, int slices = 6)
{
    SmallSeries series;
    series.size = {11, 7, slices};
    series.rowDirection = directions[0];
    series.columnDirection = directions[1];
    series.placeEvenly({-40.25, -31.5, 812.125}, directions[2] * 2.5 + shear);
    return series;
}

} // namespace

std::vector<SeriesPlacement> seriesPlacements()
{
    const glm::dmat3 supine(1.0);
    const glm::dvec3 none(0.0);
    const glm::dmat3 oblique(
        glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -0.5))));
    std::vector<SeriesPlacement> all{
        {.name = "axial", .series = placed(supine, none)},
        {.name = "prone", .series = placed({-1, 0, 0, 0, -1, 0, 0, 0, 1}, none)},
        {.name = "flipped", .series = placed({1, 0, 0, 0, -1, 0, 0, 0, -1}, none)},
        {.name = "coronal", .series = placed({1, 0, 0, 0, 0, -1, 0, 1, 0}, none)},
        {.name = "sagittal", .series = placed({0, 1, 0, 0, 0, -1, -1, 0, 0}, none)},
        {.name = "oblique", .series = placed(oblique, none)},
        {.name = "tilted", .series = placed(supine, {0, 0.8, 0}), .tilted = true},
        {.name = "oblique and tilted", .series = placed(oblique, 0.8 * oblique[1]), .tilted = true},
        {.name = "one slice", .series = placed(supine, none, 1)},
        {.name = "uneven", .series = placed(supine, none), .even = false},
    };
    all.back().series.positions.back() += glm::dvec3(0, 0, 3);
    return all;
}

void addPlacementRows(bool uneven)
{
    QTest::addColumn<QString>("placement");
    for (const SeriesPlacement& placement : seriesPlacements()) {
        if (uneven || placement.even)
            QTest::newRow(placement.name) << QString::fromLatin1(placement.name);
    }
}

SeriesPlacement placementOf(const QString& name)
{
    for (SeriesPlacement& placement : seriesPlacements()) {
        if (QLatin1String(placement.name) == name)
            return std::move(placement);
    }
    qFatal("no placement %s", qPrintable(name));
}

QString sha256OfLabel(const std::vector<std::uint8_t>& labels, int label)
{
    QByteArray mask(qsizetype(labels.size()), 0);
    for (std::size_t i = 0; i < labels.size(); ++i)
        mask[qsizetype(i)] = char(labels[i] == label);
    return QString::fromLatin1(QCryptographicHash::hash(mask, QCryptographicHash::Sha256).toHex());
}

LabelledSeries::LabelledSeries(
    const SmallSeries& series, std::vector<std::uint8_t> gridLabels, Write write)
    : volume((series.*write)(images))
    , labels(std::move(gridLabels))
{
}

qsizetype LabelledSeries::fileCount() const
{
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size();
}

} // namespace test
