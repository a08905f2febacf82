package mien;

// Written by abi/generate_bindings.py.
/**
 * A named vertex of the template.
 * @param name
 * @param vertex
 */
public record Landmark(String name, int vertex) implements Record_ {
    @Override
    public void fill(Call call, Memory at, int offset) {
        at.bytes.putInt(offset + 8, vertex);
        at.bytes.putLong(offset + 0, Memory.address(call.text(name)));
    }
}
