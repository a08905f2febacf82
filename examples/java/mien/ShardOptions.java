package mien;

// Written by abi/generate_bindings.py.
/** mien_shard_options of the C interface. */
public final class ShardOptions implements Record_ {
    private int part;
    private int partCount;
    private int maxRank;
    private int[] stableVertices;

    /** With the library's defaults. */
    public ShardOptions() {
        try (Call call = new Call()) {
            Memory at = call.room(56);
            int offset = 0;
            Raw.GET.mien_shard_options_init(at.address, 56);
            part = at.bytes.getInt(offset + 4);
            partCount = at.bytes.getInt(offset + 8);
            maxRank = at.bytes.getInt(offset + 12);
        }
    }

    /** 0 to part_count - 1, default 0: which subjects */
    public ShardOptions part(int value) {
        part = value;
        return this;
    }
    public int part() { return part; }

    /** default 1: all subjects */
    public ShardOptions partCount(int value) {
        partCount = value;
        return this;
    }
    public int partCount() { return partCount; }

    /** of identities and of expressions, default 512; parts with fewer subjects and faces are exact */
    public ShardOptions maxRank(int value) {
        maxRank = value;
        return this;
    }
    public int maxRank() { return maxRank; }

    /** as in mien_train_options; all parts of a dataset are aligned alike; null: faces as they lie */
    public ShardOptions stableVertices(int[] value) {
        stableVertices = value;
        return this;
    }
    public int[] stableVertices() { return stableVertices; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_shard_options_init(at.address + offset, 56);
        at.bytes.putInt(offset + 4, part);
        at.bytes.putInt(offset + 8, partCount);
        at.bytes.putInt(offset + 12, maxRank);
        at.bytes.putLong(offset + 40, Memory.address(call.array(stableVertices)));
        at.bytes.putLong(offset + 48, call.rows(stableVertices, 1, "stable_vertices"));
    }

    Memory write(Call call, Progress progress, Cancel cancel) {
        Memory at = call.room(56);
        fill(call, at, 0);
        at.bytes.putLong(16, call.progressFunction(progress));
        at.bytes.putLong(24, call.progressUser());
        at.bytes.putLong(32, Memory.address(call.useOrNull(cancel)));
        return at;
    }
}
