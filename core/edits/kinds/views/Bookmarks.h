// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"

#include <QString>

#include <glm/glm.hpp>

namespace core {

/// Keep a view of the patient by name.
struct AddBookmark {
    QString name{};
    OrthographicView view{}; ///< of the 3D view
    glm::dvec3 crosshairLps{0.0};
};

struct RemoveBookmark {
    int bookmark = 0; ///< id
};

} // namespace core
