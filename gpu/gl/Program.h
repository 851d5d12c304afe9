// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/GlId.h"
#include "gpu/shaders/ShaderLibrary.h"

#include <glm/glm.hpp>

#include <bitset>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gpu {

/// As many work groups as every OpenGL 4.5 driver starts at once along an axis
/// (GL_MAX_COMPUTE_WORK_GROUP_COUNT); a kernel with more to do walks, or is started again.
constexpr std::size_t mostWorkGroups = 65535;

struct ComputeProgramOptions {
    const char* label = ""; ///< a word that is there as long as the program runs (GpuTrace)
    const char* path = ""; ///< below gpu/, e.g. "kernels/sculpt/laserCut.comp"
    ShaderDefines defines{};
};

struct GraphicsProgramOptions {
    const char* label = ""; ///< as above
    const char* vertexPath = "shaders/fullScreen.vert";
    const char* fragmentPath = "";
    ShaderDefines defines{}; ///< for both stages
};

/// A linked shader program. The constructors throw ShaderError with file and line. Programs that
/// every engine needs are made where its thread starts, the variants of passes and kernels when one
/// first needs them; the engine turns the exception into an Error of its start, of the edit or of
/// the picture.
///
/// Uniforms are set by name; the program need not be in use. A name that the program does not have
/// is ignored, so that variants by #define share their setters.
/// Texture units, image units and buffer bindings are fixed in the shaders by layout(binding = n);
/// gpu/README.md lists them.
class Program {
public:
    Program() = default;
    Program(const ShaderLibrary& library, const ComputeProgramOptions& options);
    Program(const ShaderLibrary& library, const GraphicsProgramOptions& options);

    [[nodiscard]] GLuint id() const { return m_id.get(); }
    explicit operator bool() const { return bool(m_id); }
    [[nodiscard]] bool hasUniform(std::string_view name) const { return location(name) >= 0; }

    Program& set(std::string_view name, bool value);
    Program& set(std::string_view name, int value);
    Program& set(std::string_view name, unsigned value);
    Program& set(std::string_view name, float value);
    Program& set(std::string_view name, const glm::ivec2& value);
    Program& set(std::string_view name, const glm::ivec3& value);
    Program& set(std::string_view name, const glm::ivec4& value);
    Program& set(std::string_view name, const glm::uvec2& value);
    Program& set(std::string_view name, const glm::uvec3& value);
    Program& set(std::string_view name, const glm::uvec4& value);
    Program& set(std::string_view name, const glm::vec2& value);
    Program& set(std::string_view name, const glm::vec3& value);
    Program& set(std::string_view name, const glm::vec4& value);
    Program& set(std::string_view name, const glm::mat3& value);
    Program& set(std::string_view name, const glm::mat4& value);
    /// Arrays; the name is given without "[0]".
    Program& set(std::string_view name, std::span<const int> values);
    Program& set(std::string_view name, std::span<const unsigned> values);
    Program& set(std::string_view name, std::span<const float> values);
    Program& set(std::string_view name, std::span<const glm::vec4> values);
    Program& set(std::string_view name, std::span<const glm::ivec4> values);
    /// A set of labels as `uint name[8]`: label n is bit n % 32 of word n / 32.
    Program& set(std::string_view name, const std::bitset<256>& labels);

    void use() const;
    /// Makes it the current program and queues work groups. The caller places memory barriers.
    void dispatch(const glm::uvec3& groups) const;
    /// The same with the group counts in three words of @p groups at byte @p offset.
    void dispatchIndirect(const Buffer& groups, std::size_t offset = 0) const;

private:
    void link(const char* label, std::span<const GLuint> shaders);
    [[nodiscard]] GLint location(std::string_view name) const;

    struct Uniform {
        std::string name;
        GLint location = -1;
    };
    GlId<glDelete::program> m_id;
    const char* m_label = "";
    std::vector<Uniform> m_uniforms; ///< sorted by name
};

} // namespace gpu
