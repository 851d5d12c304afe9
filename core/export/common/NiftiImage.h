// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <nifti1_io.h>

#include <memory>

namespace core {

// Access to NIfTI through its C library, for checks that share no code with our own reader and
// writer.

struct NiftiDeleter {
    void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using NiftiPointer = std::unique_ptr<nifti_image, NiftiDeleter>;

/// RAS in the file's unit of length (NIFTI_UNITS_…) → LPS mm.
[[nodiscard]] glm::dmat4 lpsFrom(const mat44& ras, int units);

} // namespace core
