package mien;

// Written by abi/generate_bindings.py.
/**
 * A named set of vertices of a surface, read in place and only during the call.
 * @param name
 * @param vertices vertex_count vertex numbers, repeated ones count once
 */
public record Zone(String name, int[] vertices) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putLong(offset + 0, Memory.address(call.text(name)));
        call.required(vertices, "vertices");
        at.bytes.putLong(offset + 8, Memory.address(call.array(vertices)));
        at.bytes.putLong(offset + 16, call.rows(vertices, 1, "vertices"));
    }
}
