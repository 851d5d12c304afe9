// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/sessions/SmallDocument.h"

#include "core/edits/document/DocumentEdits.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

core::Document smallDocument()
{
    core::Volume volume;
    volume.geometry.size = {20, 16, 10};
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(-0.5, 0, 0, 0), glm::dvec4(0, 0.5, 0, 0),
        glm::dvec4(0, 0, -2, 0), glm::dvec4(100, -50, 30, 1));
    volume.encoding = {.rescaleSlope = 0.25, .rescaleIntercept = -1024};
    core::Document document = core::initialDocument(volume);
    for (int i = 0; i < 3; ++i)
        static_cast<void>(core::applyToDocument(newSegment(QStringLiteral("S")), document));
    return document;
}

} // namespace test
