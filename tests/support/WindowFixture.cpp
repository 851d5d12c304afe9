// SPDX-License-Identifier: Apache-2.0
#include "tests/support/WindowFixture.h"

#include "ui/Theme.h"

#include <QApplication>
#include <QTest>

#include <glm/gtc/matrix_transform.hpp>

namespace test {

namespace {

const glm::ivec3 size(64, 48, 40);
const glm::dvec3 spacing(2.0, 2.0, 3.0);

/// Columns of the direction matrix are the index axes; the volume's middle lies at the origin.
glm::dmat4 affine(const glm::dmat3& direction)
{
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis] = glm::dvec4(direction[axis] * spacing[axis], 0.0);
    const glm::dvec3 middle = glm::dmat3(matrix) * (0.5 * glm::dvec3(size - 1));
    matrix[3] = glm::dvec4(-middle, 1.0);
    return matrix;
}

} // namespace

core::LoadedVolume plainCt(const glm::dmat4& indexToWorld)
{
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.identity.patientName = QStringLiteral("TEST^WINDOW");
    volume.identity.patientId = QStringLiteral("T-0815");
    volume.identity.birthDate = QStringLiteral("1961-02-03");
    volume.identity.studyDate = QStringLiteral("2026-11-20");
    volume.identity.seriesNumber = QStringLiteral("3");
    volume.identity.seriesDescription = QStringLiteral("Plain");
    volume.identity.modality = QStringLiteral("CT");
    volume.geometry.size = size;
    volume.geometry.indexToWorld = indexToWorld;
    volume.encoding.rescaleIntercept = -1024.0;
    volume.unit = QStringLiteral("HU");
    volume.minimum = -24.0;
    volume.maximum = 39.0;
    volume.histogram = {-24.0, 39.0, std::vector<std::uint32_t>(64, 1)};
    volume.defaultWindow = {40.0, 400.0};
    loaded.codes.resize(volume.geometry.voxelCount());
    for (std::size_t voxel = 0; voxel < loaded.codes.size(); ++voxel)
        loaded.codes[voxel] = std::uint16_t(1000 + voxel % std::size_t(size.x));
    return loaded;
}

glm::dmat4 headFirstSupine()
{
    return affine(glm::dmat3(1.0));
}

glm::dmat4 headFirstProne()
{
    return affine(glm::dmat3({-1, 0, 0}, {0, -1, 0}, {0, 0, 1}));
}

glm::dmat4 sagittalAcquisition()
{
    return affine(glm::dmat3({0, 1, 0}, {0, 0, -1}, {-1, 0, 0}));
}

glm::dmat4 oblique()
{
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), glm::radians(10.0), {0.0, 0.0, 1.0})
        * glm::rotate(glm::dmat4(1.0), glm::radians(25.0), {1.0, 0.0, 0.0});
    return affine(glm::dmat3(turned));
}

WindowFixture::WindowFixture(const glm::dmat4& indexToWorld, const QSize& windowSize)
    : WindowFixture(plainCt(indexToWorld), windowSize)
{
}

WindowFixture::WindowFixture(core::LoadedVolume volume, const QSize& windowSize)
    : workspace(frames)
    , window(workspace, QStringLiteral("fake"))
{
    ui::theme::apply(*qApp);
    auto session = core::EditSession::create(engine, std::move(volume), {});
    if (!session)
        qFatal("the fixture's session could not be made");
    workspace.setSession(std::move(*session));
    window.resize(windowSize);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window))
        qFatal("the window does not show");
}

} // namespace test
