// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/context/EglContext.h"

#include "gpu/gl/context/CallsDriver.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <string_view>
#include <vector>

namespace gpu {

struct EglContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    // The display is the process's, shared with other contexts on it: never terminated.
    ~Handles()
    {
        const CallsDriver calls;
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
    }
};

namespace {

bool hasWord(const char* list, std::string_view word)
{
    std::string_view rest = list != nullptr ? list : "";
    while (!rest.empty()) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == word)
            return true;
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return false;
}

/// Hardware devices only: Mesa lists its software device too, last.
std::vector<EGLDisplay> hardwareDisplays()
{
    std::vector<EGLDisplay> displays;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasWord(extensions, "EGL_EXT_device_enumeration")
        || !hasWord(extensions, "EGL_EXT_platform_device"))
        return displays;
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count))
        return displays;
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        if (hasWord(
                eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
            continue;
        // The EXT entry point: libepoxy aborts on the core name where the client library is
        // EGL 1.4.
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
    return displays;
}

/// What the driver has instead of OpenGL 4.5.
core::Clause whatThereIs(EGLDisplay display, EGLConfig config)
{
    const core::Clause none = core::Clause::saying("no OpenGL 4.5 core context");
    const std::array<EGLint, 1> any{EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, any.data());
    if (context == EGL_NO_CONTEXT)
        return none;
    core::Clause told = none;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        const auto text = [](GLenum name) {
            return QString::fromUtf8(reinterpret_cast<const char*>(glGetString(name)));
        };
        told = core::Clause::saying("%1 has OpenGL %2", text(GL_RENDERER), text(GL_VERSION));
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
    return told;
}

/// @param robust out of bounds nothing is harmed, and a reset is told as a lost context
EGLContext makeContext(
    EGLDisplay display, EGLConfig config, const EglContextOptions& options, bool robust)
{
    // The names of OpenGL; those of EGL_EXT_create_context_robustness itself are for OpenGL ES.
    const EGLint flags = (options.debug ? EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : 0)
        | (robust ? EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR : 0);
    const std::array<EGLint, 11> attributes{EGL_CONTEXT_MAJOR_VERSION_KHR, 4,
        EGL_CONTEXT_MINOR_VERSION_KHR, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR, EGL_CONTEXT_FLAGS_KHR, flags,
        robust ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR : EGL_NONE,
        EGL_LOSE_CONTEXT_ON_RESET_KHR, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

/// @return why not, empty when it worked
core::Clause createOn(EGLDisplay display, const EglContextOptions& options, EGLContext& context)
{
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        return core::Clause::saying("the display cannot be initialised");
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!hasWord(extensions, "EGL_KHR_surfaceless_context"))
        return core::Clause::saying("EGL_KHR_surfaceless_context is missing");
    if (!eglBindAPI(EGL_OPENGL_API))
        return core::Clause::saying("no desktop OpenGL");
    EGLConfig config = nullptr;
    if (!hasWord(extensions, "EGL_KHR_no_config_context")) {
        const std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLint count = 0;
        if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0)
            return core::Clause::saying("no framebuffer configuration");
    }
    if (hasWord(extensions, "EGL_EXT_create_context_robustness"))
        context = makeContext(display, config, options, true);
    if (context == EGL_NO_CONTEXT)
        context = makeContext(display, config, options, false);
    return context == EGL_NO_CONTEXT ? whatThereIs(display, config) : core::Clause();
}

} // namespace

core::Result<std::unique_ptr<EglContext>> EglContext::create(const EglContextOptions& options)
{
    const CallsDriver calls;
    std::vector<EGLDisplay> displays = hardwareDisplays();
    if (hasWord(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    core::Clause reason = core::Clause::saying("no device and no surfaceless platform");
    for (EGLDisplay display : displays) {
        auto handles = std::make_unique<Handles>();
        handles->display = display;
        reason = createOn(display, options, handles->context);
        if (reason.isEmpty())
            return std::unique_ptr<EglContext>(new EglContext(std::move(handles)));
    }
    return core::failure(core::ErrorCode::GraphicsUnavailable, QStringLiteral("EGL"), reason);
}

EglContext::EglContext(std::unique_ptr<Handles> handles)
    : m_handles(std::move(handles))
{
}

EglContext::~EglContext() = default;

bool EglContext::makeCurrent()
{
    // The bound API is a state of the thread, not of the process.
    return eglBindAPI(EGL_OPENGL_API)
        && eglMakeCurrent(m_handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_handles->context);
}

void EglContext::doneCurrent()
{
    eglMakeCurrent(m_handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace gpu
