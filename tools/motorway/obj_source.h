/* An OBJ file that is kept to be written again with other positions and normals. */
#ifndef MOTORWAY_TOOL_OBJ_SOURCE_H
#define MOTORWAY_TOOL_OBJ_SOURCE_H

#include <cstddef>
#include <string>
#include <vector>

#include "mesh.h"
#include "source_text.h"

namespace motorway::tool {

class ObjSource : public MeshSource {
public:
    /* Where in the text the first number of each vertex and of each normal stands. */
    struct Places {
        std::vector<std::size_t> positions, normals;
    };

    ObjSource(SourceText source, Places places);

    const char *kind() const override { return ".obj"; }
    std::string write(const Pose &pose) const override;

private:
    SourceText source_;
    Places places_;
};

} // namespace motorway::tool

#endif
