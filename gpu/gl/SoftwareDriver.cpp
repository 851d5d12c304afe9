// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/SoftwareDriver.h"

#include "gpu/gl/Gl.h"

#include <string_view>

namespace gpu {

bool isSoftwareDriver()
{
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view renderer = name ? name : "";
    return renderer.find("llvmpipe") != std::string_view::npos
        || renderer.find("softpipe") != std::string_view::npos;
}

bool isByProcessor(WorkBy by)
{
    return by == WorkBy::Driver ? isSoftwareDriver() : by == WorkBy::Processor;
}

} // namespace gpu
